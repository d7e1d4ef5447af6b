// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Clients that come and go in several threads while a reporter runs, starts and stops.
#include "tcp_fixture.hpp"

#include <atomic>
#include <random>

namespace {

using namespace components_test;

/** Does at random what a client may do, and checks that frames are whole. */
void beClient(unsigned int port, std::mt19937& random) {
    TcpPeer client(port);
    if (!client.connected() || random() % 8 == 0) return;
    if (random() % 8 == 0) {
        std::string bytes;
        for (int i = 0; i < 300; ++i) bytes += static_cast<char>(random());
        client.send(bytes);
        return;
    }
    if (!client.greet()) return;
    client.send("SUBSCRIBE TimeStamp\nSUBSCRIBE Machine.speed\nSUBSCRIBE Machine.levels\n");
    if (random() % 4 == 0) client.send("SILENCE ON\nHEADERS\nSILENCE OFF\nUNSUBSCRIBE TimeStamp\n");
    std::string open;
    for (int lines = static_cast<int>(random() % 400); lines > 0; --lines) {
        const std::string line = client.line();
        if (line == "(end)" || line == "(silence)") break;
        if (line.substr(0, 4) == "201 ") {
            EXPECT_EQ("", open);
            open = line.substr(4, line.find(' ', 4) - 4);
        } else if (line.substr(0, 4) == "203 ") {
            EXPECT_EQ(open, line.substr(4, line.find(' ', 4) - 4));
            open.clear();
        } else if (line.substr(0, 2) == "20") {
            EXPECT_NE("", open) << line;
        } else {
            EXPECT_EQ("", open) << line;
        }
    }
    if (random() % 2 == 0) client.send("QUIT\n");
}

TEST_F(TcpReports, ClientsComeAndGoWhileItStartsAndStops) {
    reporter->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001, nullptr, "Reporter"));
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    property<unsigned int>("max_clients") = 3;
    property<unsigned int>("max_backlog") = 2000;
    std::atomic<bool> ended{false};
    std::atomic<unsigned int> port{0};
    std::vector<std::thread> threads;
    for (unsigned int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            std::mt19937 random(i);
            while (!ended)
                if (const unsigned int now = port) beClient(now, random);
        });
    threads.emplace_back([&] {
        for (unsigned int i = 0; !ended; ++i) {
            machine.speed.write(i);
            machine.levels.write(std::vector<double>(i % 7, 0.5));
        }
    });
    for (int round = 0; round < 8; ++round) {
        EXPECT_TRUE(reporter->start());
        port = this->port();
        std::this_thread::sleep_for(std::chrono::milliseconds(round % 2 == 0 ? 300 : 20));
        EXPECT_TRUE(reporter->stop());
    }
    EXPECT_TRUE(reporter->start());
    reporter.reset();
    ended = true;
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
