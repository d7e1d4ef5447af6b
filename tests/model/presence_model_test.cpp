// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/checked_presence.hpp>

namespace {

using model::require;
using model::Trial;
using RTT::internal::Presence;

/** Is taken away while threads use it. */
struct Object {
    std::atomic<bool> gone{false};
    model::Plain<int> value{1};
    alignas(16) char keys[32] = {};
    // Not the one whose bell is also that of a place which is free.
    const char* const key =
        &Presence::bellOf(reinterpret_cast<std::uintptr_t>(keys)) == &Presence::bellOf(0) ? keys + 16 : keys;

    explicit Object(bool asymmetric = true) { model::preparePresence(asymmetric); }
    void use() {
        Presence::Place& place = Presence::enter(key);
        if (!gone) require(value == 1, "used after it was taken away");
        Presence::leave(place);
    }
    void takeAway() {
        gone = true;
        Presence::Waiter(key).wait(RTT::os::detail::kForever);
        value = 2;
    }
};

template <bool asymmetric>
void taking(Trial& trial) {
    Object object(asymmetric);
    trial.thread([&] { object.use(); });
    trial.thread([&] { object.takeAway(); });
    trial.go();
}

/** What was done in a use is seen by a thread that finds the next one, of something else, in its place. */
void usingTwice(Trial& trial) {
    Object object;
    std::uint16_t other = 0;
    trial.thread([&] {
        object.use();
        Presence::leave(Presence::enter(&other));
    });
    trial.thread([&] { object.takeAway(); });
    trial.go();
}

/** Two threads wait for the end of one use. */
void twoWait(Trial& trial) {
    Object object;
    std::atomic<bool> ended{false};
    trial.thread([&] {
        Presence::Place& place = Presence::enter(object.key);
        ended.store(true, std::memory_order_relaxed);
        object.value = 2;
        Presence::leave(place);
    });
    for (int i = 0; i != 2; ++i)
        trial.thread([&] {
            if (!ended.load(std::memory_order_relaxed)) return;
            Presence::Waiter(object.key).wait(RTT::os::detail::kForever);
            require(object.value == 2, "the use has not ended");
        });
    trial.go();
}

/** A thread uses more than its first record has places for. */
void nesting(Trial& trial) {
    Object object;
    std::uint16_t other = 0;
    trial.thread([&] {
        Presence::Place* places[Presence::kDepth];
        for (Presence::Place*& place : places) place = &Presence::enter(&other);
        object.use();
        for (unsigned i = Presence::kDepth; i != 0; --i) Presence::leave(*places[i - 1]);
        object.use();
    });
    trial.thread([&] { object.takeAway(); });
    trial.go();
}

/** The thread that takes it away uses it itself, and does not wait for that. Another one waits for it. */
void within(Trial& trial) {
    Object object;
    trial.thread([&] {
        Presence::Place& place = Presence::enter(object.key);
        object.takeAway();
        Presence::forget(object.key);
        object.value = 3;
        require(!Presence::leave(place), "marked");
    });
    trial.thread([&] { Presence::Waiter(object.key).wait(RTT::os::detail::kForever); });
    trial.go();
    require(object.value == 3, "not taken away");
}

/** A thread uses it within the use of something that it has destroyed meanwhile. */
void withinSomethingForgotten(Trial& trial) {
    Object object;
    std::uint16_t other = 0;
    trial.thread([&] {
        Presence::Place& outer = Presence::enter(&other);
        Presence::Place& inner = Presence::enter(object.key);
        Presence::forget(&other);
        if (!object.gone) require(object.value == 1, "used after it was taken away");
        Presence::leave(inner);
        Presence::leave(outer);
    });
    trial.thread([&] { object.takeAway(); });
    trial.go();
}

TEST(Presence, a_user_is_waited_for) { EXPECT_TRUE(model::holds(taking<true>)); }
TEST(Presence, a_user_is_waited_for_without_membarrier) { EXPECT_TRUE(model::holds(taking<false>)); }
TEST(Presence, uses_that_follow_each_other) { EXPECT_TRUE(model::holds(usingTwice)); }
TEST(Presence, two_threads_wait) { EXPECT_TRUE(model::holds(twoWait)); }
TEST(Presence, nested_uses) { EXPECT_TRUE(model::holds(nesting)); }
TEST(Presence, taken_away_within) { EXPECT_TRUE(model::holds(within)); }
TEST(Presence, within_something_forgotten) { EXPECT_TRUE(model::holds(withinSomethingForgotten)); }

TEST(Presence, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("presence_no_barrier", taking<true>));
    EXPECT_TRUE(model::catches("presence_relaxed_without_membarrier", taking<false>));
    EXPECT_TRUE(model::catches("presence_end_relaxed_without_membarrier", taking<false>));
    EXPECT_TRUE(model::catches("presence_relaxed_leave", taking<true>));
    EXPECT_TRUE(model::catches("presence_relaxed_enter", usingTwice));
    EXPECT_TRUE(model::catches("presence_end_not_told", taking<true>));
    EXPECT_TRUE(model::catches("presence_no_ring", taking<true>));
    EXPECT_TRUE(model::catches("presence_waits_without_attention", taking<true>));
    EXPECT_TRUE(model::catches("presence_waits_unseen", taking<true>));
    EXPECT_TRUE(model::catches("presence_one_woken", twoWait));
    EXPECT_TRUE(model::catches("presence_one_record_looked_at", nesting));
    EXPECT_TRUE(model::catches("presence_forgotten_silently", within));
    EXPECT_TRUE(model::catches("presence_forgotten_is_free", withinSomethingForgotten));
}

}  // namespace
