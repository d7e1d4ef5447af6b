// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Frames of values whose size and members change from row to row.
#include "tcp_fixture.hpp"

#include <algorithm>

namespace {

using namespace components_test;

/** The lines of the next frame without its first and last one. */
std::vector<std::string> frameOf(TcpPeer& client) {
    std::vector<std::string> result;
    EXPECT_EQ("201 ", client.line().substr(0, 4));
    for (std::string line = client.line(); line.substr(0, 2) == "20"; line = client.line()) {
        if (line.substr(0, 4) == "203 ") return result;
        result.push_back(line);
    }
    ADD_FAILURE() << "the frame has no end";
    return result;
}

TEST_F(TcpReports, SequencesAndBagsGrowWhileClientsAreSubscribed) {
    property<bool>("ReportOnlyNewData") = true;
    for (const char* name : {"levels", "tank"}) ASSERT_TRUE(reporter->reportPort("Machine", name));
    ASSERT_TRUE(reporter->reportData("Machine", "limits"));
    ASSERT_TRUE(reporter->start());
    TcpPeer client(port()), other(port());
    for (TcpPeer* each : {&client, &other}) {
        ASSERT_TRUE(each->greet());
        for (const char* name : {"Machine.levels", "Machine.limits"})
            EXPECT_EQ(std::string("302 ") + name, each->ask(std::string("SUBSCRIBE ") + name));
    }
    EXPECT_EQ("302 Machine.tank", other.ask("SUBSCRIBE Machine.tank"));
    row();
    EXPECT_EQ((std::vector<std::string>{"202 Machine.limits"}), frameOf(client));
    EXPECT_EQ((std::vector<std::string>{"202 Machine.limits"}), frameOf(other));
    for (const int size : {1, 3, 1000, 2, 0}) {
        machine.levels.write(std::vector<double>(static_cast<std::size_t>(size), 0.5));
        sample::Tank tank;
        tank.path.resize(static_cast<std::size_t>(size), {1, 2});
        machine.tank.write(tank);
        row();
        std::vector<std::string> expected{"202 Machine.levels"}, path{"202 path"};
        for (int i = 0; i < size; ++i) {
            for (const std::string& line : {"202 " + std::to_string(i), std::string("205 0.5")})
                expected.push_back(line);
            for (const std::string& line : {"202 " + std::to_string(i), std::string("202 x"), std::string("205 1"),
                                            std::string("202 y"), std::string("205 2")})
                path.push_back(line);
        }
        path.emplace_back("202 weights");
        EXPECT_EQ(expected, frameOf(client));
        const std::vector<std::string> both = frameOf(other);
        EXPECT_NE(both.end(), std::search(both.begin(), both.end(), path.begin(), path.end())) << size;
    }
    machine.limits.ownProperty(new RTT::Property<std::string>("hint", "", " two  words, \"x\" # "));
    row();
    EXPECT_EQ((std::vector<std::string>{"202 Machine.limits", "202 hint", "205  two  words, \"x\" # "}),
              frameOf(client));
    row();
    EXPECT_EQ(std::vector<std::string>(), frameOf(client));
    EXPECT_EQ(0U, count("LostRows"));
}

}  // namespace
