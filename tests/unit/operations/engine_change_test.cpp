// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components that are started, stopped, given other activities and destroyed while others call them and write to them.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <optional>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Note;
using oroforge::test::Probe;

namespace {

/** Calls an operation again and again until told to stop. */
class CallingThread {
public:
    explicit CallingThread(OperationInterfacePart* operation)
        : call_(operation, internal::GlobalEngine::Instance()), thread_([this] { run(); }) {}
    ~CallingThread() { join(); }
    void join() {
        stop_ = true;
        if (thread_.joinable()) thread_.join();
    }
    std::atomic<int> done{0}, refused{0};

private:
    void run() {
        for (int i = 0; !stop_; ++i) {
            try {
                if (!call_.ready()) {
                    ++refused;
                    usleep(100);
                    continue;
                }
                const int answer = call_(i);
                // A component that is destroyed between the question and the call answers with a default.
                if (answer == i)
                    ++done;
                else
                    ++refused;
            } catch (const SendError&) {
                ++refused;
            }
        }
    }
    OperationCaller<int(int)> call_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

int echo(int n) { return n; }

TEST(SetActivityWhile, CallsAreWaitingExecutesThemInTheNewOne) {
    Probe server("server");
    ASSERT_TRUE(server.setActivity(new extras::SlaveActivity()));
    server.addOperation("echo", &echo, OwnThread);
    CallingThread caller(server.getOperation("echo"));
    ASSERT_TRUE(eventually([&] { return server.engine()->hasWork(); }));
    EXPECT_EQ(caller.done, 0) << "nobody updates the slave";
    EXPECT_TRUE(server.setActivity(new extras::SequentialActivity()));
    EXPECT_TRUE(eventually([&] { return caller.done > 10; }));
}

TEST(SetActivityWhile, OthersSendLosesNothing) {
    Probe server("server");
    server.addOperation("echo", &echo, OwnThread);
    CallingThread a(server.getOperation("echo")), b(server.getOperation("echo"));
    for (int i = 0; i != 40; ++i) {
        ASSERT_TRUE(i % 2 ? server.setActivity(new extras::SequentialActivity()) : server.setActivity(nullptr));
        const int before = a.done + b.done;
        ASSERT_TRUE(eventually([&] { return a.done + b.done > before + 4; }));
    }
    EXPECT_EQ(a.refused + b.refused, 0);
}

TEST(SetActivityWhile, RefusedKeepsTheEngineWithItsActivity) {
    Probe c;
    base::ActivityInterface* const before = c.getActivity();
    ASSERT_TRUE(c.start());
    EXPECT_FALSE(c.setActivity(new Activity(0, 0.0, c.engine()))) << "it is running";
    EXPECT_EQ(c.engine()->getActivity(), before);
    const int updates = c.updates;
    EXPECT_TRUE(c.trigger());
    EXPECT_TRUE(eventually([&] { return c.updates > updates; }));
}

TEST(SetActivityWhile, TheOldOneDoesNotStopIsRefused) {
    Probe c;
    base::ActivityInterface* const before = c.getActivity();
    c.getActivity<Activity>()->setStopTimeout(0.02);
    std::atomic<bool> inside{false}, release{false};
    c.addOperation(
        "wait",
        [&] {
            inside = true;
            while (!release) usleep(100);
        },
        OwnThread);
    auto handle = OperationCaller<void()>(c.getOperation("wait"), internal::GlobalEngine::Instance()).send();
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(c.setActivity(new extras::SlaveActivity()));
    EXPECT_EQ(c.getActivity(), before);
    release = true;
    EXPECT_EQ(handle.collect(), SendSuccess);
    EXPECT_TRUE(c.setActivity(new extras::SlaveActivity()));
}

TEST(StopWhile, OthersSendToASequentialComponentLosesNothing) {
    Probe server("server");
    ASSERT_TRUE(server.setActivity(new extras::SequentialActivity()));
    server.addOperation("echo", &echo, OwnThread);
    CallingThread a(server.getOperation("echo")), b(server.getOperation("echo"));
    for (int i = 0; i != 300; ++i) {
        ASSERT_TRUE(server.start());
        ASSERT_TRUE(server.stop());
    }
    const int before = a.done + b.done;
    EXPECT_TRUE(eventually([&] { return a.done + b.done > before + 10; }));
}

TEST(Storm, OfStartsAndStopsFromSeveralThreads) {
    std::atomic<int> inside{0}, most{0}, started{0}, stopped{0};
    const auto hook = [&] {
        most = std::max(most.load(), ++inside);
        --inside;
    };
    Probe c("c", TaskContext::PreOperational);  // after what its hooks use: its destructor stops it
    c.onConfigure = [&] { return hook(), true; };
    c.onStart = [&] { return hook(), ++started, true; };
    c.onStop = [&] { hook(), ++stopped; };
    c.onCleanup = hook;
    std::vector<std::thread> threads;
    for (int t = 0; t != 3; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i != 300; ++i) {
                c.configure();
                c.start();
                c.trigger();
                c.stop();
                c.cleanup();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(most, 1) << "one hook at a time";
    EXPECT_FALSE(c.inException());
    c.stop();
    EXPECT_EQ(started, stopped);
    EXPECT_LE(c.getTaskState(), TaskContext::Stopped);
    EXPECT_EQ(c.getTaskState(), c.getTargetState());
    EXPECT_TRUE(c.isConfigured() ? c.start() : c.configure() && c.start());
}

TEST(Storm, OfTriggersFromSeveralThreads) {
    Probe c;
    ASSERT_TRUE(c.start());
    std::vector<std::thread> threads;
    for (int t = 0; t != 3; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i != 3000; ++i) EXPECT_TRUE(c.trigger());
        });
    for (std::thread& thread : threads) thread.join();
    // The last one leads to a step that begins after it.
    c.onUpdate = nullptr;
    const int before = c.updates;
    EXPECT_TRUE(c.trigger());
    EXPECT_TRUE(eventually([&] { return c.updates > before; }));
}

TEST(Destruction, WhileOthersCallRefusesThem) {
    for (int round = 0; round != 60; ++round) {
        std::optional<Probe> server(std::in_place, "server");
        if (round % 3 == 1) {
            ASSERT_TRUE(server->setActivity(new extras::SequentialActivity()));
        }
        server->addOperation("echo", &echo, OwnThread);
        CallingThread a(server->getOperation("echo")), b(server->getOperation("echo"));
        ASSERT_TRUE(eventually([&] { return a.done + b.done > 3; }));
        server.reset();
        const int before = a.refused + b.refused;
        EXPECT_TRUE(eventually([&] { return a.refused + b.refused > before; })) << "nobody waits for ever";
    }
}

TEST(Destruction, MakesCallersNotReady) {
    std::optional<Probe> server(std::in_place, "server");
    server->addOperation("echo", &echo, OwnThread);
    server->addOperation("echo_client", &echo, ClientThread);
    OperationCaller<int(int)> own(server->getOperation("echo"), internal::GlobalEngine::Instance());
    OperationCaller<int(int)> client(server->getOperation("echo_client"));
    EXPECT_EQ(own(7), 7);
    EXPECT_EQ(client(7), 7);
    server.reset();
    EXPECT_FALSE(own.ready());
    EXPECT_FALSE(client.ready());
    EXPECT_EQ(own.send(1).collect(), SendFailure);
}

TEST(Destruction, WhileOthersWriteToItsEventPort) {
    struct Reader : Probe {
        InputPort<int> in{"in"};
        Reader() : Probe("reader") { addEventPort(in); }
        ~Reader() override { stop(); }
    };
    OutputPort<int> out("out");
    std::atomic<bool> stop{false};
    std::thread writer([&] {
        for (int i = 0; !stop; ++i) out.write(i);
    });
    for (int round = 0; round != 60; ++round) {
        Reader reader;
        ASSERT_TRUE(out.connectTo(&reader.in));
        ASSERT_TRUE(reader.start());
        ASSERT_TRUE(eventually([&] { return reader.updates > 2; }));
    }
    stop = true;
    writer.join();
}

TEST(Destruction, OfTwoPeersAtOnce) {
    for (int round = 0; round != 100; ++round) {
        std::optional<Probe> a(std::in_place, "a"), b(std::in_place, "b");
        ASSERT_TRUE(connectPeers(&*a, &*b));
        std::thread other([&] { a.reset(); });
        b.reset();
        other.join();
    }
}

// A component that deletes itself, as an operation of a deployer may do that it executes for another one.
struct OwnStep : testing::TestWithParam<const char*> {};

TEST_P(OwnStep, MayDestroyTheComponent) {
    const std::string where = GetParam();
    for (int round = 0; round != 30; ++round) {
        std::atomic<bool> gone{false};
        struct Suicide : Probe {
            explicit Suicide(std::atomic<bool>& g) : Probe("suicide"), gone(g) {}
            ~Suicide() override { stop(); }
            void end() {
                std::atomic<bool>& flag = gone;
                delete this;
                flag = true;
            }
            void updateHook() override {
                if (in_update) end();
            }
            std::atomic<bool>& gone;
            bool in_update = false;
        };
        auto* const component = new Suicide(gone);
        if (where == "sequential") {
            ASSERT_TRUE(component->setActivity(new extras::SequentialActivity()));
        }
        if (where == "slave") {
            ASSERT_TRUE(component->setActivity(new extras::SlaveActivity()));
        }
        component->in_update = where == "update" || where == "slave";
        component->addOperation("end", &Suicide::end, component, OwnThread);
        OperationCaller<void()> end(component->getOperation("end"), internal::GlobalEngine::Instance());
        ASSERT_TRUE(component->start());
        if (where == "slave") {
            component->getActivity()->execute();
        } else if (where != "update") {
            EXPECT_EQ(end.send().collect(), SendSuccess);
        }
        ASSERT_TRUE(eventually([&] { return gone.load(); }));
        EXPECT_TRUE(eventually([&] { return !end.ready(); }));
    }
    // The activities are destroyed there.
    Note last;
    ASSERT_TRUE(internal::GlobalEngine::Instance()->process(&last));
    EXPECT_TRUE(eventually([&] { return last.executed == 1; }));
}
INSTANTIATE_TEST_SUITE_P(Where, OwnStep, testing::Values("operation", "update", "sequential", "slave"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
