// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"
#include "together.hpp"

#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/engine/presence.hpp>

#include <memory>
#include <thread>

using namespace RTT;
using internal::Presence;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::kThreads;
using oroforge::test::together;

namespace {

constexpr int kDeep = 40;  // more than one record of a thread takes
constexpr NANO_TIME kEver = InfiniteNSecs;

/** Uses something kDeep times. */
class DeepUse {
public:
    explicit DeepUse(const void* what) {
        for (Presence::Place*& place : places_) place = &Presence::enter(what);
    }
    /** How many of them were marked. */
    int leave() {
        int marked = 0;
        for (int i = kDeep; i != 0; --i) marked += Presence::leave(*places_[i - 1]);
        return marked;
    }

private:
    Presence::Place* places_[kDeep];
};

bool othersUse(const void* what) { return Presence::Waiter(what).others(); }

}  // namespace

TEST(Presence, IsSeenByOtherThreadsHoweverDeepItNests) {
    std::uint64_t outer = 0, inner = 0, deepest = 0;
    std::atomic<int> reached{0}, wanted{0};
    std::thread user([&] {
        Presence::Place& first = Presence::enter(&outer);
        DeepUse within(&inner);
        Presence::Place& last = Presence::enter(&deepest);
        reached = 1;
        eventually([&] { return wanted == 2; });
        Presence::leave(last);
        within.leave();
        reached = 2;
        eventually([&] { return wanted == 3; });
        Presence::leave(first);
        reached = 3;
        eventually([&] { return wanted == 4; });
    });
    ASSERT_TRUE(eventually([&] { return reached == 1; }));
    EXPECT_TRUE(othersUse(&outer) && othersUse(&inner) && othersUse(&deepest));
    EXPECT_FALSE(Presence::Waiter(&deepest).wait(rtos_get_time_ns() + 1000000));
    wanted = 2;
    EXPECT_TRUE(Presence::Waiter(&deepest).wait(kEver) && Presence::Waiter(&inner).wait(kEver));
    ASSERT_TRUE(eventually([&] { return reached == 2; }));
    EXPECT_TRUE(othersUse(&outer));
    wanted = 3;
    EXPECT_TRUE(Presence::Waiter(&outer).wait(kEver));
    wanted = 4;
    user.join();
}

TEST(Presence, OfTheThreadThatAsksDoesNotCount) {
    std::uint64_t what = 0;
    DeepUse deep(&what);
    EXPECT_FALSE(othersUse(&what));
    EXPECT_EQ(Presence::keep(&what), static_cast<unsigned>(kDeep));
    EXPECT_EQ(deep.leave(), kDeep);
    Presence::Place& place = Presence::enter(&what);
    Presence::forget(&what);
    std::thread([&] { EXPECT_FALSE(othersUse(&what)); }).join();
    EXPECT_FALSE(Presence::leave(place));
}

TEST(Presence, RecordsOfThreadsThatHaveEndedAreFree) {
    std::uint64_t what = 0;
    for (int round = 0; round != 200; ++round) std::thread([&] { DeepUse(&what).leave(); }).join();
    EXPECT_FALSE(othersUse(&what));
}

// ThreadSanitizer sees two executions at the same time, and one that does not see what the last one did.
TEST(SlaveStorm, ThreadsThatTakeTurnsExcludeEachOther) {
    CountingRunner runner;
    int executed = 0;  // no atomic
    runner.onWork = [&](auto) { ++executed; };
    extras::SlaveActivity slave(&runner);
    ASSERT_TRUE(slave.start());
    std::atomic<int> granted{0};
    together([&](int self) {
        for (int i = 0; i != 2000; ++i) {
            // Mostly several times in a row, as the thread that owns it.
            for (int more = self == 0 ? 20 : i % 3; more >= 0; --more) granted += slave.execute();
            if (self != 1) continue;
            const auto answer = slave.beginInStead();
            if (answer != extras::SlaveActivity::Direct::Entered) continue;
            ++executed;
            ++granted;
            slave.endDirect();
        }
    });
    EXPECT_TRUE(slave.stop());
    EXPECT_EQ(executed, granted);
    EXPECT_GT(executed, 0);
}

TEST(SlaveStorm, StopWaitsForTheExecutionAndNothingIsExecutedAfterIt) {
    for (int round = 0; round != 200; ++round) {
        CountingRunner runner;
        auto executed = std::make_unique<int>(0);
        runner.onWork = [&](auto) { ++*executed; };
        extras::SlaveActivity slave(&runner);
        ASSERT_TRUE(slave.start());
        std::atomic<bool> end{false};
        std::thread user([&] {
            while (!end) slave.execute();
        });
        ASSERT_TRUE(eventually([&] { return runner.timeouts > 3; }));
        EXPECT_TRUE(slave.stop());
        executed.reset();
        EXPECT_FALSE(slave.execute());
        end = true;
        user.join();
    }
}
