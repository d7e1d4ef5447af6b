// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Requests while components are created, connected, run and destroyed.
#include "requests_fixture.hpp"

namespace live_test {
namespace {

TEST_F(RequestsTest, RequestsSurviveComponentsThatComeAndGo) {
    std::atomic<bool> over{false};
    std::atomic<int> lives{0};
    std::thread others([&] {
        for (int i = 0; !over; ++i) {
            Arm other("Other");
            ASSERT_TRUE(other.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, i % 2 ? 0.001 : 0.0)));
            deployer->addPeer(&other);
            (void)arm->out.connectTo(&other.in);
            (void)other.start();
            arm->out.write(i);
            std::this_thread::sleep_for(std::chrono::milliseconds(3));
            ++lives;
        }
    });
    const std::vector<json> all = {
        {{"op", "oro.tree"}},
        {{"op", "oro.show"}, {"path", "Other"}},
        {{"op", "oro.get"}, {"path", "Other.gain"}},
        {{"op", "oro.get"}, {"path", "Other.in"}},
        {{"op", "oro.set"}, {"path", "Other.gain"}, {"value", 1.5}},
        {{"op", "oro.set"}, {"path", "Other.list[1]"}, {"value", 1.5}},
        {{"op", "oro.call"}, {"path", "Other.add"}, {"arguments", {1, 2}}},
        {{"op", "oro.call"}, {"path", "Other.addHere"}, {"arguments", {1, 2}}},
        {{"op", "oro.lifecycle"}, {"component", "Other"}, {"do", "stop"}},
        {{"op", "oro.lifecycle"}, {"component", "Other"}, {"do", "start"}},
        {{"op", "oro.graph"}},
        {{"op", "oro.top"}, {"seconds", 0.001}},
        {{"op", "oro.line"}, {"line", "1 + 1"}},
    };
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    int answers = 0, errors = 0;
    while (std::chrono::steady_clock::now() < end) {
        std::vector<std::future<json>> later;
        for (std::size_t i = 0; i != all.size(); ++i) later.push_back(askLater(all[i], i % 2 ? "one" : "two"));
        for (auto& each : later) {
            ASSERT_EQ(std::future_status::ready, each.wait_for(std::chrono::seconds(20)));
            const json answer = each.get();
            ++answers;
            if (answer["op"] != "oro.error") continue;
            ++errors;
            EXPECT_THAT(answer["code"], testing::AnyOf("LIV003", "LIV008")) << answer;
        }
    }
    over = true;
    others.join();
    EXPECT_GT(answers - errors, 20);
    EXPECT_GT(lives, 10);
}

}  // namespace
}  // namespace live_test
