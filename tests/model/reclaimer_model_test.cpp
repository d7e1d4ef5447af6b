// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/checked_reclaimer.hpp>

namespace {

using model::require;
using model::Trial;
using RTT::internal::Reclaimer;

struct Object {
    explicit Object(int v) : value(v) {}
    model::Plain<int> value;
};

/** What is shared, and how often something was destroyed. */
struct Shared {
    std::atomic<Object*> object{new Object(1)};
    std::atomic<int> destroyed{0};

    explicit Shared(bool asymmetric) {
        model::prepareReclaimer(asymmetric);
        instance = this;
    }
    void look() {
        const Reclaimer::Guard guard;
        const Object* seen = object.load(std::memory_order_acquire);
        require(seen->value >= 1, "something else");
    }
    void replace(int value) {
        Object* old = object.exchange(new Object(value), std::memory_order_acq_rel);
        Reclaimer::retire(old, [](void* dead) {
            delete static_cast<Object*>(dead);
            instance->destroyed.fetch_add(1, std::memory_order_relaxed);
        });
        Reclaimer::collect();
    }
    static Shared* instance;
};
Shared* Shared::instance = nullptr;

template <bool asymmetric>
void oneReader(Trial& trial) {
    Shared shared(asymmetric);
    trial.thread([&] { shared.look(); });
    trial.thread([&] { shared.replace(2); });
    trial.go();
    Reclaimer::collect();
    require(shared.destroyed == 1 && Reclaimer::pending() == 0, "not destroyed, or twice");
}

/** The reader comes in again. */
template <bool asymmetric>
void returningReader(Trial& trial) {
    Shared shared(asymmetric);
    trial.thread([&] {
        shared.look();
        shared.look();
    });
    trial.thread([&] { shared.replace(2); });
    trial.go();
    Reclaimer::collect();
    require(shared.destroyed == 1 && Reclaimer::pending() == 0, "not destroyed, or twice");
}

template <bool asymmetric>
void twoReaders(Trial& trial) {
    Shared shared(asymmetric);
    for (int i = 0; i < 2; ++i) trial.thread([&] { shared.look(); });
    trial.thread([&] { shared.replace(2); });
    trial.go();
    Reclaimer::collect();
    require(shared.destroyed == 1 && Reclaimer::pending() == 0, "not destroyed, or twice");
}

void twoReplacers(Trial& trial) {
    Shared shared(true);
    trial.thread([&] { shared.look(); });
    trial.thread([&] { shared.replace(2); });
    trial.thread([&] { shared.replace(3); });
    trial.go();
    Reclaimer::collect();
    require(shared.destroyed == 2 && Reclaimer::pending() == 0, "not destroyed, or twice");
}

/** synchronize() waits for the reader, after that nobody is inside with the old object. */
template <bool asymmetric>
void synchronizing(Trial& trial) {
    Shared shared(asymmetric);
    trial.thread([&] { shared.look(); });
    trial.thread([&] {
        Object* old = shared.object.exchange(new Object(2), std::memory_order_acq_rel);
        Reclaimer::synchronize();
        delete old;
    });
    trial.go();
}

/** Two threads that are inside do not wait for each other. */
void bothInside(Trial& trial) {
    Shared shared(true);
    for (int i = 0; i < 2; ++i)
        trial.thread([] {
            const Reclaimer::Guard guard;
            Reclaimer::synchronize();
        });
    trial.go();
}

TEST(Reclaimer, one_reader) {
    EXPECT_TRUE(model::holds(oneReader<true>));
    EXPECT_TRUE(model::holds(oneReader<false>));
}
TEST(Reclaimer, a_reader_that_returns) {
    EXPECT_TRUE(model::holds(returningReader<true>));
    EXPECT_TRUE(model::holds(returningReader<false>));
}
TEST(Reclaimer, two_readers) {
    EXPECT_TRUE(model::holds(twoReaders<true>));
    EXPECT_TRUE(model::holds(twoReaders<false>));
}
TEST(Reclaimer, two_that_replace) { EXPECT_TRUE(model::holds(twoReplacers)); }
TEST(Reclaimer, synchronize_waits_for_those_inside) {
    EXPECT_TRUE(model::holds(synchronizing<true>));
    EXPECT_TRUE(model::holds(synchronizing<false>));
}
TEST(Reclaimer, two_that_are_inside_may_synchronize) { EXPECT_TRUE(model::holds(bothInside, {0})); }

TEST(Reclaimer, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("reclaimer_no_barrier", oneReader<true>));
    EXPECT_TRUE(model::catches("reclaimer_relaxed_fence", oneReader<false>));
    EXPECT_TRUE(model::catches("reclaimer_too_early", oneReader<true>));
    EXPECT_TRUE(model::catches("reclaimer_relaxed_look", oneReader<true>));
    EXPECT_TRUE(model::catches("reclaimer_relaxed_leave", oneReader<true>));
    EXPECT_TRUE(model::catches("reclaimer_relaxed_enter", oneReader<true>));
    EXPECT_TRUE(model::catches("reclaimer_relaxed_return", returningReader<true>));
    EXPECT_TRUE(model::catches("reclaimer_relaxed_synchronize", synchronizing<true>));
    EXPECT_TRUE(model::catches("reclaimer_waiters_forgotten", bothInside, {0}));
    EXPECT_TRUE(model::catches("reclaimer_end_unheard", synchronizing<true>));
    EXPECT_TRUE(model::catches("reclaimer_no_barrier_before_sleep", synchronizing<true>));
}

}  // namespace
