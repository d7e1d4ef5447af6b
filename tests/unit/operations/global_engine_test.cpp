// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The engine of those who are no component, and its end.
#include "probe.hpp"

#include <rtt/Operation.hpp>
#include <rtt/internal/GlobalEngine.hpp>

using namespace RTT;
using internal::GlobalEngine;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

/** Calls Release() in a thread of its own, so that a test can tell when that never returns. */
struct Releasing {
    std::shared_ptr<std::atomic<bool>> done = std::make_shared<std::atomic<bool>>(false);
    std::thread thread{[done = done] {
        GlobalEngine::Release();
        *done = true;
    }};
    ~Releasing() {
        if (*done)
            thread.join();
        else
            thread.detach();
    }
};

TEST(GlobalEngine, CanBeReleasedWhileItsThreadAsksForIt) {
    Probe c;
    std::atomic<bool> inside{false}, go{false};
    c.addOperation("op", [&] {
        inside = true;
        eventually([&] { return go.load(); });
        usleep(20000);  // Release() is under way
        return GlobalEngine::Instance() != nullptr;
    });
    OperationCaller<bool()> op(c.getOperation("op"), c.engine());
    SendHandle<bool()> handle = op.send();
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    Releasing releasing;
    go = true;
    ASSERT_TRUE(eventually([&] { return releasing.done->load(); }));
    bool asked = false;
    EXPECT_EQ(handle.collect(asked), SendSuccess);
    EXPECT_TRUE(asked);
}

TEST(GlobalEngine, IsStartedAnewAfterItsRelease) {
    Probe c;
    c.addOperation("op", [] { return 3; });
    OperationCaller<int()> op(c.getOperation("op"), c.engine());
    int result = 0;
    EXPECT_EQ(op.send().collect(result), SendSuccess);
    ExecutionEngine* const before = GlobalEngine::Instance();
    GlobalEngine::Release();
    GlobalEngine::Release();
    EXPECT_EQ(op.send().collect(result), SendSuccess);
    EXPECT_EQ(result, 3);
    EXPECT_EQ(GlobalEngine::Instance(), before) << "who keeps the pointer has the engine";
}

TEST(GlobalEngine, CallsThatNobodyExecutesAnyMoreEnd) {
    Probe c;
    std::atomic<bool> inside{false}, go{false};
    c.addOperation("slow", [&] {
        inside = true;
        eventually([&] { return go.load(); });
    });
    c.addOperation("next", [] {});
    OperationCaller<void()> slow(c.getOperation("slow"), c.engine()), next(c.getOperation("next"), c.engine());
    SendHandle<void()> first = slow.send();
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    SendHandle<void()> second = next.send();
    Releasing releasing;
    go = true;
    ASSERT_TRUE(eventually([&] { return releasing.done->load(); }));
    EXPECT_EQ(first.collect(), SendSuccess);
    EXPECT_NE(second.collectIfDone(), SendNotReady) << "executed or refused, but not forgotten";
}

TEST(GlobalEngine, IsNotReleasedByItsOwnThread) {
    Probe c;
    c.addOperation("op", [] { GlobalEngine::Release(); });
    OperationCaller<void()> op(c.getOperation("op"), c.engine());
    EXPECT_EQ(op.send().collect(), SendSuccess);
    EXPECT_EQ(op.send().collect(), SendSuccess);
}

// A function without a thread of its own, sent and not collected: the GlobalEngine comes to it when it can.
TEST(GlobalEngine, DoesNotExecuteForAComponentThatWasDestroyed) {
    Probe other("other");
    std::atomic<bool> inside{false}, go{false}, executed{false};
    other.addOperation("slow", [&] {
        inside = true;
        eventually([&] { return go.load(); });
    });
    auto gone = std::make_unique<Probe>("gone");
    gone->addOperation("op", [&] { executed = true; });
    OperationCaller<void()> slow(other.getOperation("slow"), GlobalEngine::Instance());
    OperationCaller<void()> op(gone->getOperation("op"), GlobalEngine::Instance());
    SendHandle<void()> first = slow.send();
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    SendHandle<void()> second = op.send();
    gone.reset();
    go = true;
    EXPECT_EQ(first.collect(), SendSuccess);
    EXPECT_EQ(second.collect(), SendFailure);
    EXPECT_FALSE(executed);
}

TEST(GlobalEngine, KeepsAComponentWhoseFunctionItExecutes) {
    auto component = std::make_unique<Probe>();
    std::atomic<bool> inside{false}, go{false}, destroyed{false};
    component->addOperation("op", [&] {
        inside = true;
        eventually([&] { return go.load(); });
        return destroyed.load();
    });
    SendHandle<bool()> handle = OperationCaller<bool()>(component->getOperation("op"), GlobalEngine::Instance()).send();
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    std::thread destroying([&] {
        component.reset();
        destroyed = true;
    });
    usleep(20000);  // it is at it
    go = true;
    bool early = true;
    EXPECT_EQ(handle.collect(early), SendSuccess);
    destroying.join();
    EXPECT_FALSE(early);
}

TEST(GlobalEngine, DestroysAComponentFromItsFunction) {
    auto component = std::make_unique<Probe>();
    component->addOperation("op", [&] { component.reset(); });
    OperationCaller<void()> op(component->getOperation("op"), GlobalEngine::Instance());
    EXPECT_EQ(op.send().collect(), SendSuccess);
    EXPECT_FALSE(component);
}

#ifndef __SANITIZE_THREAD__  // the destructor of the sub-class races with the function until that of TaskContext waits for it
TEST(GlobalEngineStress, ExecutesNothingForAComponentThatIsDestroyedBeforeItsCallIsCollected) {
    std::atomic<int> late{0};
    for (int i = 0; i != 500; ++i) {
        const auto destroyed = std::make_shared<std::atomic<bool>>(false);
        {
            Probe c;
            c.addOperation("op", [&late, destroyed] { late += *destroyed; });
            OperationCaller<void()>(c.getOperation("op"), GlobalEngine::Instance()).send();
            OperationCaller<bool()>(c.getOperation("isRunning"), GlobalEngine::Instance()).send();
        }
        *destroyed = true;
    }
    Probe c;
    c.addOperation("last", [] {});
    OperationCaller<void()> last(c.getOperation("last"), GlobalEngine::Instance());
    EXPECT_EQ(last.send().collect(), SendSuccess) << "all that was sent before is dealt with";
    EXPECT_EQ(late, 0);
}
#endif

TEST(GlobalEngineStress, ReleaseWhileOthersSend) {
    Probe c;
    std::atomic<long> executed{0};
    c.addOperation("op", [&] { ++executed; });
    std::atomic<bool> stop{false};
    std::vector<std::thread> senders;
    for (int i = 0; i != 2; ++i)
        senders.emplace_back([&] {
            OperationCaller<void()> op(c.getOperation("op"), GlobalEngine::Instance());
            while (!stop) {
                SendHandle<void()> handle = op.send();
                if (handle.ready()) eventually([&] { return handle.collectIfDone() != SendNotReady; });
            }
        });
    for (int i = 0; i != 50; ++i) {
        const long before = executed;
        EXPECT_TRUE(eventually([&] { return executed != before; }));
        GlobalEngine::Release();
    }
    stop = true;
    for (std::thread& sender : senders) sender.join();
}

}  // namespace
