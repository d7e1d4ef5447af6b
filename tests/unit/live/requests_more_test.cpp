// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// describe, graph, top, and the lines of a console.
#include "requests_fixture.hpp"

namespace live_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST_F(RequestsTest, ATypeIsDescribed) {
    const json policy = result("describe", {{"type", "ConnPolicy"}});
    EXPECT_EQ("struct", policy["kind"]);
    EXPECT_EQ("int", named(policy["fields"], "size")["type"]);
    EXPECT_EQ("value", result("describe", {{"type", "double"}})["kind"]);
    const json sequence = result("describe", {{"type", "array"}});
    EXPECT_EQ("sequence", sequence["kind"]);
    EXPECT_THAT(failure("describe", {{"type", "ConPolicy"}}), HasSubstr("did you mean 'ConnPolicy'?"));
}

TEST_F(RequestsTest, TheGraphHasConnectionsWithWhatTheyHold) {
    Arm other("Other");
    deployer->addPeer(&other);
    ASSERT_TRUE(arm->out.connectTo(&other.in, RTT::ConnPolicy::buffer(2)));
    for (const double value : {1.0, 2.0, 3.0, 4.0, 5.0}) arm->out.write(value);
    const json graph = result("graph");
    EXPECT_EQ(3u, graph["components"].size());
    ASSERT_EQ(1u, graph["connections"].size());
    EXPECT_EQ((json{{"from", "Arm.out"},
                    {"to", "Other.in"},
                    {"type", "double"},
                    {"policy", "buffer 2"},
                    {"samples", 2},
                    {"dropped", 3}}),
              graph["connections"][0]);
}

TEST_F(RequestsTest, TopMeasuresCycles) {
    Arm periodic("Periodic");
    ASSERT_TRUE(periodic.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.01)));
    deployer->addPeer(&periodic);
    ASSERT_TRUE(periodic.start());
    const json top = result("top", {{"seconds", 0.3}});
    EXPECT_GE(top["seconds"].get<double>(), 0.3);
    const json row = named(top["components"], "Periodic");
    EXPECT_EQ(0.01, row["period"]);
    EXPECT_EQ("ORO_SCHED_OTHER", row["scheduler"]);
    EXPECT_GE(row["cycles"].get<int>(), 2);
    EXPECT_GT(row["duration"].get<double>(), 0);
    EXPECT_LE(row["duration"], row["longest"]);
    EXPECT_TRUE(row["lateness"].is_number());
    EXPECT_GE(row["cpu"].get<double>(), 0);
    EXPECT_EQ("Stopped", named(top["components"], "Arm")["state"]);
    EXPECT_EQ(0, named(top["components"], "Arm")["cycles"]);
    periodic.stop();
}

TEST_F(RequestsTest, LinesAreThoseOfAConsole) {
    json answer = result("line", {{"line", "Arm.gain + 1"}});
    EXPECT_EQ(" = 3.5\n", answer["out"]);
    EXPECT_EQ("Deployer [S]> ", answer["prompt"]);
    EXPECT_EQ(false, answer["quits"]);
    EXPECT_EQ("Arm [S]> ", result("line", {{"line", "cd Arm"}})["prompt"]);
    EXPECT_EQ(" = 2.5\n", result("line", {{"line", "gain"}})["out"]);
    EXPECT_THAT(result("line", {{"line", "gian"}})["err"].get<std::string>(), HasSubstr("gain"));
    EXPECT_EQ(json::array({"gain"}), result("complete", {{"line", "gai"}})["words"]);
    EXPECT_EQ(true, result("line", {{"line", "quit"}})["quits"]);
    EXPECT_THAT(failure("line", {{"line", 1}}), StartsWith("LIV001"));
}

TEST_F(RequestsTest, ALongLineHoldsUpNobodyAndIsInterrupted) {
    auto line = askLater({{"op", "oro.line"}, {"line", "while (true) Arm.nothing()"}});
    while (result("interrupt")["done"] == false) std::this_thread::yield();
    ASSERT_EQ(std::future_status::ready, line.wait_for(std::chrono::seconds(10)));
    EXPECT_EQ(true, line.get()["result"]["interrupted"]);
    EXPECT_EQ(" = 2.5\n", result("line", {{"line", "Arm.gain"}})["out"]);
    requests->left("tester");
    EXPECT_EQ("Deployer [S]> ", result("line", {{"line", ""}})["prompt"]);
}

TEST_F(RequestsTest, APortIsWatchedUntilTheClientInterrupts) {
    for (const char* const command : {".watch Arm.out", ".hz Arm.out"}) {
        auto line = askLater({{"op", "oro.line"}, {"line", command}, {"live", true}});
        while (line.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) (void)result("interrupt");
        const json answer = line.get()["result"];
        EXPECT_EQ("", answer["err"]) << command;
        EXPECT_EQ(true, answer["interrupted"]) << command;
        EXPECT_THAT(result("line", {{"line", command}})["err"].get<std::string>(), HasSubstr("expected a number"));
    }
}

}  // namespace
}  // namespace live_test
