// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Threads of components that wait sleep until there is something for them, and do not look from time to time.
#include "os_test.hpp"

#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/SendHandle.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/os/futex.hpp>

#include <fstream>
#include <memory>
#include <thread>

using namespace RTT;
using oroforge::test::eventually;

namespace {

/** How often the thread has gone to sleep by itself. */
long sleeps(int tid) {
    std::ifstream status("/proc/self/task/" + std::to_string(tid) + "/status");
    const std::string key = "voluntary_ctxt_switches:";
    for (std::string word; status >> word;)
        if (word == key) return status >> word, std::stol(word);
    return -1;
}

/** It does not wake up any more, at some time. */
bool sleepsOn(int tid) {
    return eventually([&] {
        const long before = sleeps(tid);
        usleep(60000);
        return before > 0 && sleeps(tid) - before <= 2;
    });
}

/** The system can wait for several words at once. */
bool canWaitForSeveral() {
    const std::atomic<std::uint32_t> word{0};
    const os::detail::FutexWord words[2] = {{&word, 0}, {&word, 0}};
    const nsecs begin = rtos_get_time_ns();
    return !os::detail::futexWaitAny(words, 2, begin + 20000000) && rtos_get_time_ns() - begin >= 20000000;
}

struct Component : TaskContext {
    std::function<void()> onUpdate;
    std::atomic<int> notes{0};
    explicit Component(const std::string& name) : TaskContext(name) {
        addOperation(
            "note", [this] { ++notes; }, OwnThread);
        addOperation("wait", &Component::wait, this, OwnThread);
    }
    ~Component() override { stop(); }
    void updateHook() override {
        if (onUpdate) onUpdate();
    }
    struct Door {
        std::atomic<bool> inside{false}, release{false};
    };
    const std::shared_ptr<Door> door = std::make_shared<Door>();  // may outlive the component
    void wait() {
        const auto mine = door;
        mine->inside = true;
        eventually([&] { return mine->release.load(); });
    }
    int tid() { return static_cast<int>(getActivity<Activity>()->getPid()); }
    OperationCaller<void()> call(const char* name, ExecutionEngine* caller = internal::GlobalEngine::Instance()) {
        return OperationCaller<void()>(getOperation(name), caller);
    }
};

struct EngineWait : testing::Test {
    void SetUp() override {
        if (!canWaitForSeveral()) GTEST_SKIP() << "before Linux 5.16 these threads look each millisecond";
    }
    Component server{"server"};
};

TEST_F(EngineWait, OfAThreadWithinTwoComponentsEndsWithAMessageForEither) {
    Component master("master"), slave("slave");
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(master.getActivity())));
    OperationCaller<void()> wait = server.call("wait", slave.engine());
    std::atomic<bool> returned{false};
    slave.onUpdate = [&] {
        wait();
        returned = true;
    };
    master.onUpdate = [&] { slave.update(); };
    ASSERT_TRUE(slave.start());
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(eventually([&] { return server.door->inside.load(); }));
    EXPECT_TRUE(sleepsOn(master.tid()));
    for (int i = 1; i <= 20; ++i) {
        master.call("note")();
        EXPECT_EQ(master.notes, i);
        slave.call("note")();
        EXPECT_EQ(slave.notes, i);
    }
    EXPECT_FALSE(returned);
    server.door->release = true;
    EXPECT_TRUE(eventually([&] { return returned.load(); }));
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
    EXPECT_TRUE(slave.stop());
    EXPECT_TRUE(slave.setActivity(new extras::SequentialActivity));
}

TEST_F(EngineWait, ForACallThatAnotherComponentSentEndsWithTheCall) {
    Component collector("collector"), sender("sender");
    SendHandle<void()> handle = server.call("wait", sender.engine()).send();
    std::atomic<bool> returned{false};
    collector.onUpdate = [&] {
        EXPECT_EQ(handle.collect(), SendSuccess);
        returned = true;
    };
    ASSERT_TRUE(collector.start());
    ASSERT_TRUE(eventually([&] { return server.door->inside.load(); }));
    EXPECT_TRUE(sleepsOn(collector.tid()));
    collector.call("note")();
    EXPECT_EQ(collector.notes, 1);
    EXPECT_FALSE(returned);
    server.door->release = true;
    EXPECT_TRUE(eventually([&] { return returned.load(); }));
    EXPECT_TRUE(eventually([&] { return collector.stop(); }));
}

// A component destroys another one that a third thread is executing, and goes on executing its messages.
TEST_F(EngineWait, ForTheEndOfAComponentEndsWithItsLastVisitor) {
    Component destroyer("destroyer");
    auto victim = std::make_unique<Component>("victim");
    const auto door = victim->door;
    ASSERT_TRUE(victim->setActivity(new extras::SequentialActivity));
    OperationCaller<void()> wait = victim->call("wait");
    std::thread visitor([&] { wait(); });
    ASSERT_TRUE(eventually([&] { return door->inside.load(); }));
    std::atomic<bool> destroyed{false};
    destroyer.onUpdate = [&] {
        victim.reset();
        destroyed = true;
    };
    ASSERT_TRUE(destroyer.start());
    // stop() of the sequential activity gives up after a second; from then on messages are executed.
    destroyer.call("note")();
    EXPECT_FALSE(destroyed);
    EXPECT_TRUE(sleepsOn(destroyer.tid()));
    destroyer.call("note")();
    EXPECT_EQ(destroyer.notes, 2);
    EXPECT_FALSE(destroyed);
    door->release = true;
    EXPECT_TRUE(eventually([&] { return destroyed.load(); }));
    visitor.join();
    destroyer.onUpdate = nullptr;
}

TEST_F(EngineWait, OfAThreadThatIsNoComponentEndsWithTheLastVisitorToo) {
    auto victim = std::make_unique<Component>("victim");
    const auto door = victim->door;
    ASSERT_TRUE(victim->setActivity(new extras::SequentialActivity));
    OperationCaller<void()> wait = victim->call("wait");
    std::thread visitor([&] { wait(); });
    ASSERT_TRUE(eventually([&] { return door->inside.load(); }));
    std::atomic<int> tid{0};
    std::atomic<bool> taken{false};
    std::thread taker([&] {
        tid = static_cast<int>(os::detail::currentTid());
        victim->engine()->setActivity(nullptr);
        taken = true;
    });
    ASSERT_TRUE(eventually([&] { return tid != 0; }));
    EXPECT_TRUE(sleepsOn(tid));
    EXPECT_FALSE(taken);
    door->release = true;
    taker.join();
    visitor.join();
}

}  // namespace
