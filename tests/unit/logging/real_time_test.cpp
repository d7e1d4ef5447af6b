// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a thread that logs to a category does: no allocation, no lock, no wait.
#include "logging_fixture.hpp"

#include <support/real_time_trap.hpp>

#include <pthread.h>
#include <thread>

namespace {

using namespace logging_test;
using log4cpp::Priority;
using oroforge::test::expectRealTime;

class RealTime : public Logging {
protected:
    void SetUp() override {
        OROFORGE_NEEDS_REAL_TIME_TRAP();
        Logging::SetUp();
        connect("robot.arm", listener);
        connect("robot", second);
        ASSERT_TRUE(service->configure());
        category("robot.arm").setPriority(Priority::DEBUG);
    }
    void TearDown() override {
        if (service) Logging::TearDown();
    }
    Listener listener;
    Listener second{"second"};
};

void logAll(Category& to, const RTT::rt_string& message) {
    to.info("a literal that does not fit into a string without memory of its own");
    to.log(Priority::WARN, message);
    to.debug(message), to.notice(message), to.error(message), to.crit(message), to.alert(message), to.emerg(message);
    to.getRTStream(Priority::INFO) << "a number: " << 42 << ", another: " << 0.25 << ", a text: " << message << ' '
                                   << true;
    to.getRTStream(Priority::NOTSET) << "ignored";
}

TEST_F(RealTime, LoggingNeitherAllocatesNorLocks) {
    Category& to = category("robot.arm");
    const RTT::rt_string message("a message in real-time memory, which was there before");
    // The first time in a thread, too.
    std::thread([&] {
        for (int i = 0; i < 3; ++i) expectRealTime([&] { logAll(to, message); });
    }).join();
    EXPECT_EQ(27u, listener.messages().size());
    EXPECT_EQ(27u, second.messages().size());
}

TEST_F(RealTime, NorDoesItWhenTheBufferIsFullOrNobodyListens) {
    Category& to = category("robot.arm");
    const RTT::rt_string message("a message in real-time memory, which was there before");
    for (int i = 0; i < 20; ++i) expectRealTime([&] { logAll(to, message); });
    EXPECT_EQ(100u, listener.messages().size());
    expectRealTime([&] { logAll(category("robot.arm"), message); }, 0);
    ASSERT_TRUE(service->cleanup());
    expectRealTime([&] { logAll(to, message); });
    to.setPriority(Priority::EMERG);
    expectRealTime([&] { to.error("below the level"); });
}

TEST_F(RealTime, MessagesOfTheReservedSizeNeedNoMemory) {
    Category& to = category("robot.arm");
    const std::string text(200, 'x');  // MessageSize
    for (int i = 0; i < 200; ++i) expectRealTime([&] { to.info(text.c_str()); });
    for (const std::string& message : listener.messages()) EXPECT_EQ(text, message);
}

}  // namespace
