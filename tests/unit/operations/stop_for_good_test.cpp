// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component is stopped for good before its class is destroyed: nothing of it is executed by other threads afterwards.
#include "probe.hpp"

#include <rtt/InputPort.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/engine/deferred_activity.hpp>

#include <filesystem>
#include <memory>
#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Note;
using oroforge::test::Probe;

namespace {

#ifdef OROFORGE_STRESS_CALLS
constexpr int kRounds = 5000;
#else
constexpr int kRounds = 300;
#endif

/** As orocreate-pkg writes it. */
class Usual : public TaskContext {
public:
    explicit Usual(const std::string& name) : TaskContext(name) {
        addOperation("own", &Usual::fill, this, OwnThread);
        addOperation("client", &Usual::fill, this, ClientThread);
        addOperation("nested", &Usual::nested, this, ClientThread);
        addPort(in);
        ports()->addEventPort(event);
    }
    ~Usual() override { stopForGood(); }

    void fill(int count) {
        texts.clear();
        for (int i = 0; i != count; ++i) texts.push_back("a text that is longer than what fits into a string");
    }
    void nested(int count) {
        OperationCaller<void(int)> own(getOperation("own"), internal::GlobalEngine::Instance());
        try {
            if (own.ready()) own(count);
        } catch (const SendError&) {  // it is being destroyed
        }
    }
    bool dataOnPortHook(base::PortInterface*) override { return !texts.empty(); }

    std::vector<std::string> texts{"one"};
    InputPort<int> in{"in"}, event{"event"};
};

/** Sends to a component while another thread makes and destroys it. */
void storm(const char* operation, TaskContext* (*create)()) {
    for (int round = 0; round != kRounds; ++round) {
        std::unique_ptr<TaskContext> component(create());
        OperationCaller<void(int)> caller(component->getOperation(operation), internal::GlobalEngine::Instance());
        ASSERT_TRUE(component->start());
        std::atomic<bool> go{false}, over{false};
        std::thread sender([&] {
            go = true;
            while (!over) {
                caller.send(20);
                if (!caller.ready()) usleep(10);
            }
        });
        while (!go) usleep(1);
        usleep(50);
        component.reset();
        over = true;
        sender.join();
    }
}

TEST(StopForGood, OwnThreadOperationsAreSentWhileItIsDestroyed) {
    storm("own", []() -> TaskContext* { return new Usual("usual"); });
}
TEST(StopForGood, ClientThreadOperationsAreSentWhileItIsDestroyed) {
    storm("client", []() -> TaskContext* { return new Usual("usual"); });
}
TEST(StopForGood, OperationsThatCallOthersOfTheSameComponent) {
    storm("nested", []() -> TaskContext* { return new Usual("usual"); });
}

TEST(StopForGood, AWriterAsksNoHookOfAClassThatIsDestroyed) {
    OutputPort<int> out("out");
    std::atomic<bool> over{false};
    std::thread writer([&] {
        for (int i = 0; !over; ++i) out.write(i);
    });
    for (int round = 0; round != kRounds; ++round) {
        Usual usual("usual");
        ASSERT_TRUE(out.connectTo(&usual.event));
        ASSERT_TRUE(usual.start());
        usleep(20);
    }
    over = true;
    writer.join();
}

TEST(StopForGood, WhatWasQueuedFailsAndWhatIsSentIsRefused) {
    Usual component("component");
    OperationCaller<void(int)> own(component.getOperation("own"), internal::GlobalEngine::Instance());
    OperationCaller<void(int)> client(component.getOperation("client"), internal::GlobalEngine::Instance());
    ASSERT_TRUE(component.getActivity()->stop());
    SendHandle<void(int)> queued = own.send(1);
    EXPECT_EQ(queued.collectIfDone(), SendNotReady);
    component.stopForGood();
    EXPECT_EQ(queued.collectIfDone(), SendFailure);
    std::thread other([&] {
        EXPECT_FALSE(own.ready());
        EXPECT_FALSE(client.ready());
        own(3);  // not ready: an error in the log
        EXPECT_EQ(client.send(3).collect(), SendFailure);
        Note note;
        EXPECT_FALSE(component.engine()->process(&note));
        EXPECT_FALSE(component.activate());
    });
    other.join();
    EXPECT_EQ(component.texts.size(), 1u);
}

TEST(StopForGood, StopsTheComponentOnceAndItStartsNoMore) {
    Probe component;
    ASSERT_TRUE(component.start());
    component.takeHooks();
    component.stopForGood();
    component.stopForGood();
    EXPECT_EQ(component.takeHooks(), "stop");
    EXPECT_FALSE(component.isActive());
    EXPECT_FALSE(component.start());
    EXPECT_FALSE(component.activate());
    EXPECT_FALSE(component.isActive());
}

TEST(StopForGood, ThrowsNothing) {
    Probe component;
    component.onStop = [] { throw std::runtime_error("stopHook"); };
    ASSERT_TRUE(component.start());
    component.stopForGood();
    EXPECT_FALSE(component.isActive());
}

// Its destructor may still call what it provides, and other components.
TEST(StopForGood, TheThreadThatDestroysItGoesOnUsingIt) {
    Usual peer("peer"), component("component");
    OperationCaller<void(int)> own(component.getOperation("own"), component.engine());
    OperationCaller<void(int)> others(peer.getOperation("own"), component.engine());
    component.stopForGood();
    others(5);
    EXPECT_EQ(peer.texts.size(), 5u);
    own(3);
    EXPECT_EQ(component.texts.size(), 3u);
    EXPECT_EQ(own.send(4).collect(), SendFailure);
    OperationCaller<void(int)> client(component.getOperation("client"));
    client(2);
    EXPECT_EQ(component.texts.size(), 2u);
}

TEST(StopForGood, AClientThreadOperationThatIsBeingExecutedIsWaitedFor) {
    Probe component;
    std::atomic<bool> inside{false}, leave{false};
    component.addOperation(
        "busy",
        [&] {
            inside = true;
            EXPECT_TRUE(eventually([&] { return leave.load(); }));
            inside = false;
        },
        ClientThread);
    OperationCaller<void()> busy(component.getOperation("busy"), internal::GlobalEngine::Instance());
    SendHandle<void()> handle = busy.send();
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    std::thread other([&] {
        usleep(20000);
        leave = true;
    });
    component.stopForGood();
    EXPECT_FALSE(inside);
    other.join();
}

// Nobody but the destructor may be able to end it.
TEST(StopForGood, GivesUpAfterItsLimitAndLetsNoFurtherStepBegin) {
    Probe component;
    std::atomic<bool> leave{false}, inside{false};
    component.onUpdate = [&] {
        inside = true;
        while (!leave) usleep(100);
    };
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(component.stopForGood(0.05));
    const int updates = component.updates;
    leave = true;
    EXPECT_TRUE(component.stopForGood());
    usleep(20000);
    EXPECT_LE(component.updates, updates + 1);
}

TEST(StopForGood, AnotherThreadMayDestroyItAfterwards) {
    auto component = std::make_unique<Usual>("component");
    std::thread([&] { component->stopForGood(); }).join();
    component.reset();
}

// What calls it is not waited for: it is this thread.
TEST(StopForGood, WithinAStepOfTheComponentItself) {
    Probe component;
    std::atomic<int> later{0};
    component.addOperation(
        "end", [&] { component.stopForGood(); }, OwnThread);
    component.addOperation(
        "later", [&] { ++later; }, OwnThread);
    OperationCaller<void()> end(component.getOperation("end"), internal::GlobalEngine::Instance());
    OperationCaller<void()> after(component.getOperation("later"), internal::GlobalEngine::Instance());
    ASSERT_TRUE(component.start());
    EXPECT_EQ(end.send().collect(), SendSuccess);
    EXPECT_EQ(after.send().collect(), SendFailure);
    EXPECT_EQ(later, 0);
}

TEST(StopForGood, OfActivitiesWithoutAThreadOfTheirOwn) {
    for (const bool slave : {false, true}) {
        Probe component;
        base::ActivityInterface* const activity =
            slave ? static_cast<base::ActivityInterface*>(new extras::SlaveActivity())
                  : new extras::SequentialActivity();
        ASSERT_TRUE(component.setActivity(activity));
        int calls = 0;
        component.addOperation(
            "count", [&] { return ++calls; }, OwnThread);
        OperationCaller<int()> count(component.getOperation("count"), internal::GlobalEngine::Instance());
        component.stopForGood();
        std::thread other([&] {
            EXPECT_FALSE(count.ready());
            count();
            EXPECT_FALSE(component.update());
            EXPECT_FALSE(component.trigger());
        });
        other.join();
        EXPECT_EQ(calls, 0);
    }
}

int threads() {
    namespace fs = std::filesystem;
    return static_cast<int>(std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator()));
}

TEST(StopForGood, MakesNoThread) {
    const internal::ActivityFollows follows("promised");
    Usual component("promised");
    const int before = threads();
    component.stopForGood();
    EXPECT_EQ(threads(), before);
    // Destructors that do so as well.
    ASSERT_NE(component.getActivity(), nullptr);
    component.getActivity()->stop();
    EXPECT_EQ(threads(), before);
}

}  // namespace
