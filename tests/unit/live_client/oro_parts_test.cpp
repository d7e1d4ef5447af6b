// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Parts of oro that need no deployment.
#include <live/client/canvas.hpp>
#include <live/client/command.hpp>
#include <live/client/completion.hpp>
#include <live/client/connection.hpp>
#include <live/client/discovery.hpp>
#include <live/client/failure.hpp>
#include <live/client/json.hpp>
#include <live/client/output.hpp>
#include <live/client/statistics.hpp>
#include <live/client/value_text.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace oroforge::live_client {
namespace {

using testing::HasSubstr;

TEST(OroAddress, HasItsParts) {
    const Address full = parseAddress("ws://10.0.0.1:9000/?token=abc#x");
    EXPECT_EQ("10.0.0.1", full.host);
    EXPECT_EQ("9000", full.port);
    EXPECT_EQ("/?token=abc", full.target);
    const Address least = parseAddress("http://localhost?token=a");
    EXPECT_EQ("localhost", least.host);
    EXPECT_EQ("8765", least.port);
    EXPECT_EQ("/?token=a", least.target);
    const Address six = parseAddress("ws://[::1]:8765");
    EXPECT_EQ("::1", six.host);
    EXPECT_EQ("8765", six.port);
    EXPECT_EQ("/", six.target);
    EXPECT_EQ("::1", parseAddress("ws://[::1]/").host);
}

TEST(OroAddress, IsRefusedIfWrong) {
    for (const char* const url : {"", "localhost:8765", "wss://a", "ws://", "ws://:1", "ws://a:", "ws://a:0",
                                  "ws://a:65536", "ws://a:-1", "ws://a:1x", "ws://a b", "ws://a\r\nX: y"}) {
        try {
            parseAddress(url);
            ADD_FAILURE() << "'" << url << "' was taken";
        } catch (const Failure& failure) {
            EXPECT_EQ(Status::Usage, failure.status());
            EXPECT_THAT(failure.what(), HasSubstr("write an address as 'deployer --web' prints it"));
        }
    }
}

TEST(OroDiscovery, ReadsNamesOfSockets) {
    const Deployment one = fromFileName("/run", "12-my-arm.v2.sock");
    EXPECT_EQ(12, one.pid);
    EXPECT_EQ("my-arm.v2", one.name);
    EXPECT_EQ("/run/12-my-arm.v2.sock", one.socket);
    for (const char* const name : {"", ".", "..", "12", "12-.sock", "-a.sock", "x-a.sock", "1x-a.sock", "0-a.sock",
                                   "12-a", "12-a.socket", "99999999999999999999-a.sock", "12 -a.sock", "+1-a.sock"})
        EXPECT_EQ(0, fromFileName("/run", name).pid) << name;
}

TEST(OroJson, ReadsWithoutTrust) {
    EXPECT_TRUE(parsed("{\"a\": 1").is_discarded());
    EXPECT_TRUE(parsed(std::string(101, '[') + std::string(101, ']')).is_discarded());
    EXPECT_FALSE(parsed(std::string(100, '[') + std::string(100, ']')).is_discarded());
    EXPECT_FALSE(parsed("\"" + std::string(500, '[') + "\\\"" + std::string(500, '{') + "\"").is_discarded());
    EXPECT_EQ("", textOf(parsed("[1]"), "a"));
    EXPECT_EQ("[1]", textOf(parsed("{\"a\": [1]}"), "a"));
    EXPECT_EQ(7, wholeOf(parsed("{\"a\": 1.5}"), "a", 7));
    EXPECT_EQ("\"\uFFFD\"", lineOf(Json("\xff")));
    EXPECT_EQ("\"\\u009b\\u007f§ä\\u001b\"", lineOf(Json("\u009b\x7f§ä\033")));
    EXPECT_EQ("\u009b\x7f§", parsed(lineOf(Json("\u009b\x7f§"))).get<std::string>());
}

TEST(OroValues, AreWrittenAsInTheConsole) {
    EXPECT_EQ("{x = 1, name = \"a\", on = true}", valueText(parsed(R"({"x": 1.0, "name": "a", "on": true})")));
    EXPECT_EQ("0.1", valueText(Json(0.1)));
    EXPECT_EQ("0.30000000000000004", valueText(Json(0.1 + 0.2)));
    EXPECT_EQ("1e+300", valueText(Json(1e300)));
    EXPECT_EQ("18446744073709551615", valueText(Json(std::numeric_limits<std::uint64_t>::max())));
    EXPECT_EQ("[]", valueText(Json::array()));
    EXPECT_EQ("[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, … 90 more]", valueText(Json(std::vector<int>(100, 0))));
}

TEST(OroValues, KeepTheBlanksOfTexts) {
    EXPECT_EQ(R"("a   b")", shownText({{"text", R"("a   b")"}}));
    EXPECT_EQ("[1 2]", shownText({{"text", "[1\n   2]"}}));
}

TEST(OroValues, MayLackElements) {
    const Json value = parsed(R"({"list": [1], "points": [{"x": 1}]})");
    for (const char* const path : {"list[1]", "list.1", "points[3].x"}) EXPECT_TRUE(lacksElement(value, path)) << path;
    for (const char* const path : {"list[0]", "lost[0]", "points[0].y", "points.x", "", "list."})
        EXPECT_FALSE(lacksElement(value, path)) << path;
}

TEST(OroValues, HaveMembersByPath) {
    const Json value = parsed(R"({"pose": {"x": 1, "n": null}, "joints": [{"q": 5}, {"q": 6}]})");
    EXPECT_EQ(Json(1), *memberAt(value, "pose.x"));
    EXPECT_EQ(Json(6), *memberAt(value, "joints[1].q"));
    EXPECT_EQ(Json(6), *memberAt(value, "joints.1.q"));
    EXPECT_EQ(Json(nullptr), *memberAt(value, "pose.n"));
    EXPECT_EQ(&value, memberAt(value, ""));
    for (const char* const path :
         {"pose.y", "joints[2]", "joints[-1]", "joints[x]", "joints[", "pose.x.z", "joints[99999999999999999999]"})
        EXPECT_EQ(nullptr, memberAt(value, path)) << path;
    std::vector<std::string> names;
    for (const auto& leaf : leavesOf(value)) names.push_back(leaf.first);
    EXPECT_THAT(names, testing::ElementsAre("pose.x", "pose.n", "joints[0].q", "joints[1].q"));
    EXPECT_TRUE(std::isnan(*asNumber(Json("NaN"))));
    EXPECT_FALSE(asNumber(Json("1")));
}

TEST(OroStatistics, AreThoseOfTheNumbers) {
    Statistics all;
    EXPECT_EQ(0, all.deviation());
    for (const double value : {1e9 + 1, 1e9 + 3, 1e9 + 5}) all.add(value);
    EXPECT_EQ(1e9 + 1, all.least());
    EXPECT_EQ(1e9 + 5, all.greatest());
    EXPECT_NEAR(1e9 + 3, all.mean(), 1e-6);
    EXPECT_NEAR(2, all.deviation(), 1e-6);
}

TEST(OroCanvas, DrawsBraille) {
    Canvas canvas(2, 1);
    canvas.set(0, 0);
    canvas.set(3, 3);
    canvas.set(-1, 0);
    canvas.set(4, 0);
    EXPECT_THAT(canvas.rows(), testing::ElementsAre("\u2840\u2808"));
    Canvas full(1, 1);
    for (long x = 0; x != 2; ++x) full.line(x, 0, x, 3);
    EXPECT_THAT(full.rows(), testing::ElementsAre("\u28FF"));
}

TEST(OroCanvas, DrawsAnyNumbers) {
    const double infinite = std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::max();
    EXPECT_EQ(5U, curve({}, 10, 40, 5).size());
    EXPECT_THAT(curve({{0, 2}}, 10, 40, 5).front(), HasSubstr("3 ┤"));
    const auto lines = curve({{0, -most}, {1, infinite}, {2, std::nan("")}, {3, most}}, 10, 40, 5);
    EXPECT_THAT(lines.front(), HasSubstr("1.7977e+308 ┤"));
    for (const std::string& line : lines) EXPECT_LE(OCL::console::widthOf(line), 41U) << line;
}

TEST(OroOutput, HasNoControlCharacters) {
    EXPECT_EQ("a?[31mb c?", printable("a\033[31mb\nc\x7f"));
    EXPECT_EQ("ä€?x", printable("ä€\u0085x"));
    EXPECT_EQ("a?b?c–", printable("a\u202Eb\u2066c\u2013")) << "text in the other direction";
    EXPECT_EQ("a\xE2\x80", printable("a\xE2\x80"));
}

TEST(OroCommands, AreComplete) {
    std::set<std::string> names;
    for (const Command& command : commands()) {
        EXPECT_TRUE(names.insert(command.name).second) << command.name;
        EXPECT_FALSE(command.examples.empty()) << command.name;
        EXPECT_EQ('.', std::string(command.text).back()) << command.name;
        EXPECT_NE(nullptr, command.run);
        std::set<std::string> keys{"help", "version"};
        for (const Option& option : commonOptions()) keys.insert(keyOf(option));
        for (const Option& option : command.options) {
            EXPECT_TRUE(keys.insert(keyOf(option)).second) << command.name << " " << option.names;
            EXPECT_EQ('.', std::string(option.text).back()) << option.names;
        }
    }
    EXPECT_EQ("OPERATION [ARGUMENT...]", usageOf(*commandNamed("call")));
    EXPECT_EQ("follow", keyOf(commandNamed("log")->options.front()));
}

std::vector<std::string> wordsFor(const std::vector<std::string>& typed) {
    std::vector<std::string> words;
    for (const Candidate& one : candidatesFor(typed)) words.push_back(one.word);
    return words;
}

TEST(OroCompletion, KnowsTheTable) {
    EXPECT_THAT(wordsFor({"co"}), testing::ElementsAre("configure", "console", "completion"));
    EXPECT_THAT(wordsFor({"echo", "--c"}), testing::ElementsAre("--csv", "--count"));
    EXPECT_THAT(wordsFor({"--format", ""}), testing::ElementsAre("text", "json"));
    EXPECT_THAT(wordsFor({"--format=json", "completion", "z"}), testing::ElementsAre("zsh"));
    EXPECT_THAT(wordsFor({"log", "--level", "W"}), testing::ElementsAre("Warning"));
    EXPECT_THAT(wordsFor({"mcap", "c"}), testing::ElementsAre("cat", "convert"));
    EXPECT_THAT(wordsFor({"mcap", "cat", "--"}), testing::IsEmpty());
    EXPECT_THAT(wordsFor({"man", "ec"}), testing::ElementsAre("echo"));
    EXPECT_THAT(wordsFor({"completion", "bash", ""}), testing::IsEmpty());
    EXPECT_THAT(wordsFor({}), testing::IsEmpty());
    for (const char* const shell : {"bash", "zsh", "fish"}) EXPECT_THAT(scriptOf(shell), HasSubstr("oro __complete"));
}

}  // namespace
}  // namespace oroforge::live_client
