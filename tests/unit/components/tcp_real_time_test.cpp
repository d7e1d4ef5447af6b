// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A row for clients costs the reporter's own thread no allocation, lock or wait, even if a client does not read.
#include "tcp_fixture.hpp"

#include <support/real_time_trap.hpp>

namespace {

using namespace components_test;
using oroforge::test::expectRealTime;

TEST_F(TcpReports, TheHookDoesNothingThatARealTimeThreadMustNot) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    machine.levels.write(std::vector<double>(2000, 0.123456));
    for (const char* name : {"levels", "place", "mode"}) ASSERT_TRUE(reporter->reportPort("Machine", name));
    ASSERT_TRUE(reporter->reportData("Machine", "label"));
    property<unsigned int>("max_backlog") = 100000;
    reporter->setActivity(new RTT::extras::SlaveActivity(0.001));
    ASSERT_TRUE(reporter->start());
    TcpPeer stopped(port(), 4096), good(port());
    for (TcpPeer* client : {&stopped, &good}) {
        ASSERT_TRUE(client->greet());
        ASSERT_EQ("302 Machine.levels", client->ask("SUBSCRIBE Machine.levels"));
    }
    std::thread reader([&] { (void)good.rest(); });
    reporter->update();
    for (int i = 0; i < 200; ++i) {
        machine.place.write({1.0 * i, 2});
        machine.levels.write(std::vector<double>(2000, i));
        expectRealTime([this] { reporter->update(); });
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    reporter->update();
    EXPECT_GT(count("dropped_frames"), 0u);
    EXPECT_EQ(0u, count("LostRows"));
    ASSERT_TRUE(reporter->stop());
    reader.join();
}

}  // namespace
