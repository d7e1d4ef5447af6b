// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions that an engine executes once per step: scripts and state machines.
#include "probe.hpp"

#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <memory>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::makeManual;
using oroforge::test::Note;
using oroforge::test::Probe;
using oroforge::test::Steps;

namespace {

TEST(EngineFunctions, AreExecutedOncePerStepUntilDone) {
    Probe probe;
    makeManual(probe);
    int left = 3;
    Steps function([&] { return --left != 0; });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    for (int i = 1; i <= 3; ++i) {
        ASSERT_TRUE(probe.update());
        EXPECT_EQ(function.executions, i);
        EXPECT_EQ(function.isLoaded(), i != 3);
    }
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(function.executions, 3);
    EXPECT_TRUE(probe.engine()->runFunction(&function)) << "can be loaded again";
    EXPECT_TRUE(probe.engine()->removeFunction(&function));
    EXPECT_FALSE(function.isLoaded());
}

TEST(EngineFunctions, OneThatIsLoadedIsNotTakenASecondTime) {
    Probe probe, other("other");
    makeManual(probe);
    makeManual(other);
    auto function = std::make_unique<Steps>([] { return false; });
    ASSERT_TRUE(probe.engine()->runFunction(function.get()));
    EXPECT_FALSE(probe.engine()->runFunction(function.get()));
    EXPECT_FALSE(other.engine()->runFunction(function.get()));
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(function->executions, 1);
    ASSERT_FALSE(function->isLoaded());
    function.reset();  // who is not loaded is known to nobody
    EXPECT_TRUE(probe.update() && other.update());
}

TEST(EngineFunctions, OneMayRemoveItselfOrAnotherWhileItExecutes) {
    Probe probe;
    std::atomic<int> others{0};
    Steps other([&] { return ++others, true; });
    Steps self([&] {
        probe.engine()->removeFunction(&other);
        probe.engine()->removeFunction(&self);
        return true;
    });
    ASSERT_TRUE(probe.engine()->runFunction(&self));
    ASSERT_TRUE(probe.engine()->runFunction(&other));
    ASSERT_TRUE(probe.trigger());
    ASSERT_TRUE(eventually([&] { return !self.isLoaded(); }));
    EXPECT_EQ(others, 0);
    EXPECT_FALSE(other.isLoaded());
    EXPECT_EQ(self.executions, 1);
    probe.getActivity()->stop();  // it is still in the function that removed itself
}

TEST(EngineFunctions, RemovingFromAnotherThreadWaitsUntilItIsNotExecuting) {
    Probe probe;
    probe.setPeriod(0.001);
    std::atomic<bool> inside{false};
    Steps function([&] {
        inside = true;
        usleep(3000);
        inside = false;
        return true;
    });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_TRUE(probe.engine()->removeFunction(&function));
    EXPECT_FALSE(inside);
    const int executions = function.executions;
    usleep(10000);
    EXPECT_EQ(function.executions, executions);
}

// An operation that is executed while the function waits in a call takes the removal: it must not count as its end.
TEST(EngineFunctions, RemovingWaitsAlsoForOneThatWaitsInACall) {
    Probe probe, server("server");
    std::atomic<bool> inside{false}, release{false}, ended{false}, removed{false};
    server.addOperation(
        "wait",
        [&] {
            inside = true;
            while (!release) usleep(100);
        },
        OwnThread);
    OperationCaller<void()> wait(server.getOperation("wait"), probe.engine());
    Steps function([&] {
        wait();
        usleep(2000);
        ended = true;
        return true;
    });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    ASSERT_TRUE(probe.trigger());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    std::thread remover([&] {
        EXPECT_TRUE(probe.engine()->removeFunction(&function));
        EXPECT_TRUE(ended);
        removed = true;
    });
    usleep(5000);
    EXPECT_FALSE(removed);
    release = true;
    remover.join();
    EXPECT_FALSE(function.isLoaded());
    EXPECT_EQ(function.executions, 1);
}

// The function calls the component that removes it.
TEST(EngineFunctions, RemoverGoesOnExecutingItsOwnMessages) {
    Probe probe, remover("remover");
    std::atomic<bool> inside{false}, removing{false};
    std::atomic<int> served{0}, result{-1};
    remover.addOperation(
        "serve", [&] { ++served; }, OwnThread);
    OperationCaller<void()> serve(remover.getOperation("serve"), probe.engine());
    Steps function([&] {
        inside = true;
        while (!removing) usleep(100);
        usleep(2000);
        serve();
        return true;
    });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    ASSERT_TRUE(probe.trigger());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    remover.onUpdate = [&] {
        removing = true;
        result = probe.engine()->removeFunction(&function);
    };
    ASSERT_TRUE(remover.start());
    ASSERT_TRUE(eventually([&] { return result != -1; }));
    EXPECT_EQ(result, 1);
    EXPECT_EQ(served, 1);
    remover.stop();
}

// Two components, each in a call of an operation that ends when a function of the other one has.
TEST(EngineFunctions, OnesThatOthersWaitForAreExecutedDuringACall) {
    struct Awaited : Steps {
        using Steps::Steps;
        bool isAwaited() const override { return true; }
    };
    Probe first("first"), second("second");
    Probe* const both[] = {&first, &second};
    std::atomic<int> parts[2] = {{0}, {0}}, done{0}, others{0};
    Awaited functions[2] = {Awaited([&] { return ++parts[0] != 3; }), Awaited([&] { return ++parts[1] != 3; })};
    Steps other([&] { return ++others, true; });
    OperationCaller<void()> waits[2];
    for (int i = 0; i != 2; ++i) {
        both[i]->addOperation(
            "wait", [&, i] { both[i]->engine()->waitForMessages([&] { return parts[i] == 3; }); }, OwnThread);
        waits[i] = OperationCaller<void()>(both[i]->getOperation("wait"), both[1 - i]->engine());
        both[i]->onUpdate = [&, i] {
            if (both[i]->updates == 0) waits[1 - i]();
            ++done;
        };
        ASSERT_TRUE(both[i]->engine()->runFunction(&functions[i]));
    }
    ASSERT_TRUE(first.engine()->runFunction(&other));
    ASSERT_TRUE(first.start() && second.start());
    EXPECT_TRUE(eventually([&] { return done >= 2; }));
    EXPECT_EQ(functions[0].executions + functions[1].executions, 6);
    EXPECT_EQ(others, 1) << "waits with the component";
    EXPECT_FALSE(functions[0].isLoaded() || functions[1].isLoaded());
    for (Probe* probe : both) probe->stop();
    first.getActivity()->stop();
    EXPECT_TRUE(first.engine()->removeFunction(&other));
}

TEST(EngineFunctions, RemovingWhileTheActivityIsStoppedExecutesNothing) {
    Probe probe;
    ASSERT_TRUE(probe.getActivity()->stop());
    Note message;
    auto function = std::make_unique<Steps>([] { return true; });
    ASSERT_TRUE(probe.engine()->process(&message));
    ASSERT_TRUE(probe.engine()->runFunction(function.get()));
    EXPECT_TRUE(probe.engine()->removeFunction(function.get()));
    EXPECT_FALSE(function->isLoaded());
    function.reset();
    EXPECT_EQ(message.executed, 0) << "messages are for the thread of the component";
    ASSERT_TRUE(probe.activate());
    EXPECT_TRUE(eventually([&] { return message.executed == 1; }));
}

TEST(EngineFunctions, RemovingEndsThoughTheActivityStopsMeanwhile) {
    Note busy([&] { usleep(30000); });  // may be queued until the component ends
    Probe probe;
    Steps function([] { return true; });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    ASSERT_TRUE(probe.engine()->process(&busy));
    std::thread stopper([&] { probe.getActivity()->stop(); });
    EXPECT_TRUE(probe.engine()->removeFunction(&function));
    stopper.join();
    EXPECT_FALSE(function.isLoaded());
}

TEST(EngineFunctions, RemovingAfterFatalErrorWaitsForTheStep) {
    Probe probe;
    std::atomic<bool> failed{false}, ended{false};
    Steps function([&] {
        probe.fatal();
        failed = true;
        usleep(5000);
        ended = true;
        return true;
    });
    Steps other([] { return true; });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    ASSERT_TRUE(probe.engine()->runFunction(&other));
    ASSERT_TRUE(probe.trigger());
    ASSERT_TRUE(eventually([&] { return failed.load(); }));
    EXPECT_TRUE(probe.engine()->removeFunction(&function));
    EXPECT_TRUE(ended);
    EXPECT_EQ(other.executions, 0) << "in FatalError no function is executed";
    EXPECT_TRUE(probe.engine()->removeFunction(&other));
}

TEST(EngineFunctions, OneThatThrowsIsUnloadedAndPutsTheComponentIntoException) {
    Probe probe;
    Steps function([]() -> bool { throw 42; });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    ASSERT_TRUE(probe.trigger());
    EXPECT_TRUE(eventually([&] { return probe.inException() && !function.isLoaded(); }));
    EXPECT_TRUE(probe.isActive());
}

TEST(EngineFunctions, AreUnloadedWhenTheComponentIsDestroyed) {
    Steps running([] { return true; }), queued([] { return true; });
    {
        Probe probe;
        makeManual(probe);
        ASSERT_TRUE(probe.engine()->runFunction(&running));
        ASSERT_TRUE(probe.update());
        ASSERT_TRUE(probe.engine()->runFunction(&queued));
    }
    EXPECT_FALSE(running.isLoaded());
    EXPECT_FALSE(queued.isLoaded());
    EXPECT_EQ(queued.executions, 0);
}

TEST(EngineFunctions, OfASequentialComponentAreRemovedByAnyThread) {
    Probe probe;
    ASSERT_TRUE(probe.setActivity(new extras::SequentialActivity()));
    Steps function([] { return true; });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    const int executions = function.executions;
    EXPECT_GE(executions, 1);
    EXPECT_TRUE(probe.engine()->removeFunction(&function));
    probe.trigger();
    EXPECT_FALSE(function.isLoaded());
}

TEST(EngineFunctions, StormOfAddingAndRemoving) {
    Probe probe;
    probe.setPeriod(0.0005);
    std::vector<std::thread> threads;
    for (int t = 0; t != 3; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i != 150; ++i) {
                auto function = std::make_unique<Steps>([i] { return i % 3 != 0; });
                ASSERT_TRUE(probe.engine()->runFunction(function.get()));
                if (i % 2) usleep(200);
                ASSERT_TRUE(probe.engine()->removeFunction(function.get()));
                ASSERT_FALSE(function->isLoaded());
            }
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
