// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Logging in a real-time thread: no allocation, no lock, no wait, also when the queue is full.
#include <support/real_time_trap.hpp>

#include <rtt/Logger.hpp>
#include <rtt/os/Thread.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/oro_malloc.h>
#include <rtt/os/startstop.h>

#include <functional>
#include <gtest/gtest.h>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <thread>

using namespace RTT;
using oroforge::test::expectRealTime;

namespace {

class RealTimeLogging : public testing::Test {
protected:
    RealTimeLogging() {
        __os_init(0, nullptr);
        Logger::Instance()->setLogLevel(Logger::Warning);
        Logger::Instance()->setStdStream(console);
    }
    ~RealTimeLogging() override {
        Logger::Instance()->setStdStream(std::cerr);
        Logger::Instance()->setLogLevel(Logger::Never);
        __os_exit();
    }
    void SetUp() override {
        OROFORGE_NEEDS_REAL_TIME_TRAP();
        if (!inPlainThread([] {})) GTEST_SKIP() << "this process may not have real-time threads";
    }
    /** In a real-time thread that the runtime did not make. */
    static bool inPlainThread(const std::function<void()>& work) {
        bool done = false;
        std::thread([&] {
            sched_param parameters{};
            parameters.sched_priority = 1;
            if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) != 0) return;
            work();
            done = true;
        }).join();
        return done;
    }
    std::string logged() {
        log(Error) << "end" << endlog();
        return console.str();
    }
    std::ostringstream console;
};

class Worker : public os::Thread {
public:
    explicit Worker(std::function<void()> work)
        : Thread(ORO_SCHED_RT, os::LowestPriority, 0, 0, "worker"), work_(std::move(work)) {}
    ~Worker() override {
        stop();
        terminate();
    }

private:
    void loop() override { work_(); }
    bool breakLoop() override { return true; }
    std::function<void()> work_;
};

struct Streamable {
    int value;
};
std::ostream& operator<<(std::ostream& stream, const Streamable& s) { return stream << '<' << s.value << '>'; }

/** All spellings; nothing but the log may do what the trap catches. */
void logAll(const std::string& text) {
    Logger::In in("a module name of more than fifteen characters");
    log(Error) << "text " << text << ' ' << 1 << ' ' << 1.5 << ' ' << true << Streamable{3} << endlog();
    Logger::log(Logger::Warning) << std::hex << std::setw(8) << std::setfill('0') << 255 << Logger::nl;
    Logger::log() << Logger::Critical << std::fixed << std::setprecision(3) << 3.14159 << std::endl
                  << "more" << Logger::endl;
    log(Debug) << "nobody sees it " << text << endlog();
    log(Info) << "for the file" << endlog(Error);
    log() << std::string_view("view") << nlog() << flushlog();
}

}  // namespace

TEST_F(RealTimeLogging, AThreadOfTheRuntimeLogs) {
    const std::string text(500, 'x');
    {
        Worker worker([&] { expectRealTime([&] { logAll(text); }); });
        ASSERT_TRUE(worker.start());
        while (worker.isRunning()) std::this_thread::yield();
    }
    const std::string all = logged();
    EXPECT_NE(all.find("[a module name of more than fifteen characters] text " + text + " 1 1.5 1<3>\n"),
              std::string::npos)
        << all;
    EXPECT_NE(all.find("] 000000ff\n"), std::string::npos) << all;
    EXPECT_NE(all.find("[CRITICAL]"), std::string::npos) << all;
    EXPECT_NE(all.find("] 3.142\n    more\n"), std::string::npos) << all;
}

TEST_F(RealTimeLogging, AnyThreadLogsFromItsFirstLineOn) {
    const std::string text = "some text";
    ASSERT_TRUE(inPlainThread([&] { expectRealTime([&] { logAll(text); }); }));
    EXPECT_NE(logged().find("] text some text 1 1.5 1<3>\n"), std::string::npos) << logged();
}

TEST_F(RealTimeLogging, AFullQueueAndALongLineDoNotMatter) {
    const std::string text(10000, 'x');
    ASSERT_TRUE(inPlainThread([&] {
        expectRealTime([&] {
            for (int i = 0; i < 2000; ++i) log(Error) << text << i << endlog();
        });
    }));
    EXPECT_NE(logged().find("characters cut)"), std::string::npos);
}

TEST_F(RealTimeLogging, ExhaustedMemoryIsReportedWithoutWaiting) {
    ASSERT_TRUE(inPlainThread([] {
        // The pool itself has a mutex, held for a bounded time.
        expectRealTime([] { EXPECT_EQ(oro_rt_malloc(100u << 20), nullptr); },
                       oroforge::test::RealTimeTrap::kAllocation | oroforge::test::RealTimeTrap::kWait);
    }));
    EXPECT_NE(logged().find("[ ERROR  ][Memory] no real-time memory for 104857600 bytes"), std::string::npos)
        << logged();
}
