// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#define MODEL_SHARED_POINTERS
#include <model/checker/substitute.hpp>
#include <model/checked_presence.hpp>

#include <rtt/internal/engine/access_gate.cpp>

namespace {

using model::Trial;
using RTT::internal::AccessGate;

struct Object {
    std::shared_ptr<AccessGate> gate = std::make_shared<AccessGate>();
    std::atomic<int> uses{0};
    Object() { gate->share(); }
    ~Object() { gate->closeForGood(); }
};

/** The object is destroyed while others use it. */
template <int users>
void destroying(Trial& trial) {
    model::preparePresence();
    Object* const object = new Object;
    const std::shared_ptr<AccessGate> gate = object->gate;
    for (int i = 0; i < users; ++i)
        trial.thread([=] {
            const AccessGate::Pass pass(gate);
            if (pass) object->uses.fetch_add(1, std::memory_order_relaxed);
        });
    trial.thread([=] { delete object; });
    trial.go();
}

TEST(AccessGate, one_user) { EXPECT_TRUE(model::holds(destroying<1>)); }
TEST(AccessGate, two_users) { EXPECT_TRUE(model::holds(destroying<2>)); }

TEST(AccessGate, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("access_not_refused", destroying<1>));
    EXPECT_TRUE(model::catches("access_not_waited_for", destroying<1>));
    EXPECT_TRUE(model::catches("access_closed_late", destroying<1>));
}

}  // namespace
