// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/checked_reclaimer.hpp>

#include <rtt/internal/SignalBase.cpp>

namespace {

using model::require;
using model::Trial;
using RTT::internal::Reclaimer;
using RTT::internal::SignalBase;

struct Signal : SignalBase {
    int arity() const override { return 0; }
};

struct Function : SignalBase::Connection {
    void call(void* const*) const override { calls.fetch_add(1, std::memory_order_relaxed); }
    mutable std::atomic<int> calls{0};
};

struct World {
    Signal signal;
    std::shared_ptr<Function> first = std::make_shared<Function>(), second = std::make_shared<Function>();
    World() {
        model::prepareReclaimer();
        signal.add(first, true);
    }
};

/** Emitting while functions come and go: whoever is connected all the time is called. */
void connecting(Trial& trial) {
    World world;
    trial.thread([&] { world.signal.emitErased(nullptr); });
    trial.thread([&] { world.signal.add(world.second, true); });
    trial.go();
    require(world.first->calls == 1, "a connected function was not called");
    world.signal.emitErased(nullptr);
    require(world.first->calls == 2 && world.second->calls >= 1, "a connected function was not called");
    Reclaimer::collect();
    require(Reclaimer::pending() == 0, "lists are left");
}

void disconnecting(Trial& trial) {
    World world;
    trial.thread([&] { world.signal.emitErased(nullptr); });
    trial.thread([&] { require(world.first->disconnect(), "was not connected"); });
    trial.go();
    const int calls = world.first->calls;
    world.signal.emitErased(nullptr);
    require(world.first->calls == calls, "called after it was disconnected");
    Reclaimer::collect();
    require(Reclaimer::pending() == 0, "lists are left");
}

TEST(Signal, a_function_is_connected_while_others_emit) { EXPECT_TRUE(model::holds(connecting)); }
TEST(Signal, a_function_is_disconnected_while_others_emit) { EXPECT_TRUE(model::holds(disconnecting)); }

TEST(Signal, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("signal_freed_at_once", disconnecting));
    EXPECT_TRUE(model::catches("signal_relaxed_list", connecting));
    EXPECT_TRUE(model::catches("signal_relaxed_release", disconnecting));
}

}  // namespace
