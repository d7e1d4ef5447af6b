// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The program oro-mcap, as its user runs it.
#include "mcap_tool_fixture.hpp"

#include <algorithm>
#include <filesystem>

namespace {

using namespace mcap_test;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(Tool, InfoCountsAndChecks) {
    record("run.mcap", messages());
    const Outcome outcome = expect(0, {"info", "run.mcap"});
    EXPECT_EQ("", outcome.err);
    EXPECT_THAT(outcome.out, HasSubstr("messages    4 in 4 chunks, compression none\n"));
    EXPECT_THAT(outcome.out, HasSubstr("from        1.500000000 s\nto          3.000000000 s, 1.500000000 s\n"));
    EXPECT_THAT(outcome.out, HasSubstr("metadata    oroforge.lost: all=0\n"));
    EXPECT_THAT(outcome.out, HasSubstr("/tank/level  tank/msg/Level             2        0\n"));
    EXPECT_THAT(outcome.out, HasSubstr("/tank/count  std_msgs/msg/Int32         2        1\n"));
}

TEST_F(Tool, CatPrintsJson) {
    record("run.mcap", messages());
    const Outcome outcome = expect(0, {"cat", "run.mcap"});
    EXPECT_THAT(outcome.out,
                StartsWith(R"({"topic": "/tank/level", "time": 1.500000000, "sequence": 0, "message": {"height": 1.5, )"
                           R"("name": "a \"quoted\", text\u000a", "side": -1, "path": [{"x": 0, "y": 0.5}], )"
                           R"("valves": [true, false]}})"
                           "\n"
                           R"({"topic": "/tank/count", "time": 2.000000000, "sequence": 0, "message": {"data": -7}})"
                           "\n"));
    const Outcome one = expect(0, {"cat", "run.mcap", "--topic", "/tank/count"});
    EXPECT_EQ(2, std::count(one.out.begin(), one.out.end(), '\n'));
    EXPECT_THAT(expect(2, {"cat", "run.mcap", "--topic", "/tank/cont"}).err,
                HasSubstr("run.mcap: error: there is no topic '/tank/cont'; did you mean '/tank/count'?"));
}

TEST_F(Tool, CatPrintsUtf8) {
    record("run.mcap", {{1, 0, 0, level(1, "ü\xff\xc3|\xed\xa0\x80\xf0\x9f\x98\x80", 0)}});
    EXPECT_THAT(expect(0, {"cat", "run.mcap"}).out,
                HasSubstr("\"name\": \"ü\ufffd\ufffd|\ufffd\ufffd\ufffd\U0001f600\""));
}

TEST_F(Tool, AReaderThatHasSeenEnoughIsNoError) {
    std::vector<Told> many;
    for (std::uint32_t i = 0; i != 3000; ++i) many.emplace_back(1, i, i, level(i, std::string(100, 'x'), 1));
    record("run.mcap", many);
    Command command;
    command.program = "/bin/bash";
    command.arguments = {"-c", std::string("set -o pipefail; '") + TOOL_PROGRAM + "' cat run.mcap | head -n 1 | wc -l"};
    command.directory = directory.path();
    const Outcome outcome = oroforge::test::run(command);
    EXPECT_EQ(0, outcome.status);
    EXPECT_EQ("1\n", outcome.out);
}

TEST_F(Tool, InfoHasColumnsForLettersOfSeveralBytes) {
    MemorySink sink;
    Writer writer(sink);
    EXPECT_TRUE(writer.begin({"ros2", "a test"}) && writer.add(Channel{1, 0, "/größe", "cdr", {}}));
    EXPECT_TRUE(writer.add(Channel{2, 0, "/length", "cdr", {}}) && writer.finish());
    directory.write("run.mcap", std::string(sink.bytes.begin(), sink.bytes.end()));
    EXPECT_THAT(expect(0, {"info", "run.mcap"}).out, HasSubstr("topic    type  messages  missing\n"
                                                               "/größe   -            0        0\n"
                                                               "/length  -            0        0\n"));
}

TEST_F(Tool, TextsOfAFileDoNotCommandTheTerminal) {
    MemorySink sink;
    Writer writer(sink);
    EXPECT_TRUE(writer.begin({"ros2\033[31m", "a \u009b31mtest ü\302"}));
    EXPECT_TRUE(writer.add(Schema{1, "no/msg/\aType", "ros2msg", "string data\n"}));
    EXPECT_TRUE(writer.add(Channel{1, 1, "/a\033]0;x\a", "cdr", {}}));
    PackedChunk packed;
    Chunk chunk(1000);
    std::string why;
    EXPECT_TRUE(addTo(chunk, {1, 0, 0, "short"}) && packed.pack(chunk, nullptr, why) && writer.write(packed));
    EXPECT_TRUE(writer.add(Metadata{"x\r", {{"k", "\x7f"}}}) && writer.finish());
    directory.write("run.mcap", std::string(sink.bytes.begin(), sink.bytes.end()));
    const std::string shown = expect(0, {"info", "run.mcap"}).out;
    EXPECT_THAT(shown, HasSubstr("a ?31mtest ü\302, profile 'ros2?[31m'"));
    EXPECT_THAT(shown, HasSubstr("/a?]0;x?"));
    EXPECT_THAT(shown, HasSubstr("no/msg/?Type"));
    EXPECT_THAT(shown, HasSubstr("x?: k=?"));
    const Outcome cat = run({"cat", "run.mcap"});
    EXPECT_THAT(cat.err, HasSubstr("topic '/a?]0;x?'"));
    EXPECT_THAT(run({"info", "no\033[31m.mcap"}).err, HasSubstr("no?[31m.mcap: error:"));
}

TEST_F(Tool, AMessageThatDoesNotFitIsReportedOnce) {
    std::vector<Told> all = messages();
    all.push_back({1, 2, 4000000000, "short"});
    record("run.mcap", all);
    for (const char* const format : {"table", "csv"}) {
        const std::string said = expect(1, {"convert", "run.mcap", "--topic", "/tank/level", "--to", format}).err;
        EXPECT_THAT(said, HasSubstr("topic '/tank/level': the message at 4.000000000 does not fit its schema"));
        EXPECT_EQ(1, std::count(said.begin(), said.end(), '\n')) << said;
    }
}

TEST_F(Tool, AnUnknownCommandIsNamed) {
    EXPECT_THAT(expect(2, {"inof", "run.mcap"}).err, StartsWith("oro-mcap: error: unknown command 'inof'"));
    EXPECT_THAT(expect(2, {}).err, HasSubstr("subcommand is required"));
}

TEST_F(Tool, ReadsTypesThatAreDescribedAsIdl) {
    const char* const text =
        "module tank {\nstruct Point { uint16 x; float y; };\n"
        "struct Level { double height; string name; int8 side; sequence<Point> path; boolean valves[2]; };\n};\n";
    record("ros.mcap", messages());
    record("idl.mcap", messages(), text, "omgidl", "tank::Level");
    EXPECT_EQ(expect(0, {"cat", "ros.mcap"}).out, expect(0, {"cat", "idl.mcap"}).out);
    EXPECT_EQ(expect(0, {"convert", "ros.mcap", "--topic", "/tank/level"}).out,
              expect(0, {"convert", "idl.mcap", "--topic", "/tank/level"}).out);
    std::vector<Told> others = messages();
    std::get<3>(others[0]) = level(1.5, "a \"quoted\", text\n", 3);
    record("other.mcap", others, text, "omgidl", "tank::Level");
    EXPECT_THAT(expect(1, {"diff", "idl.mcap", "other.mcap"}).out,
                HasSubstr("message 0 at 1.500000000: a list before"));
    record("wrong.mcap", messages(), "module tank {\nstruct Level { quark q; };\n};\n", "omgidl", "tank::Level");
    EXPECT_THAT(expect(1, {"cat", "wrong.mcap"}).err,
                HasSubstr("[MCP012] topic '/tank/level': line 2: the type 'quark' is not described"));
}

TEST_F(Tool, DiffNamesTheFirstDifference) {
    record("one.mcap", messages());
    record("same.mcap", messages());
    EXPECT_EQ("", expect(0, {"diff", "one.mcap", "same.mcap"}).out);
    std::vector<Told> others = messages();
    std::get<3>(others[2]) = level(2.5, "b", 2);
    std::get<2>(others[3]) += 1;
    record("other.mcap", others);
    EXPECT_EQ(
        "/tank/level: message 1 at 2.500000000: 'height' is 2.25 in the first and 2.5 in the second\n"
        "/tank/count: message 1 is of 3.000000000 in the first and 3.000000001 in the second\n",
        expect(1, {"diff", "one.mcap", "other.mcap"}).out);
    others = messages();
    others.pop_back();
    record("shorter.mcap", others);
    EXPECT_THAT(expect(1, {"diff", "one.mcap", "shorter.mcap"}).out,
                HasSubstr("/tank/count: there are 2 messages in the first and 1 in the second"));
    record("described.mcap", messages(), std::string("# another\n") + kLevel);
    EXPECT_EQ("/tank/level: the type is described by another text\n",
              expect(1, {"diff", "one.mcap", "described.mcap"}).out);
    EXPECT_THAT(expect(2, {"diff", "one.mcap", "none.mcap"}).err, HasSubstr("none.mcap: error: "));
}

TEST_F(Tool, RecoversWhatIsWhole) {
    record("run.mcap", messages());
    const std::string bytes = readText("run.mcap");
    directory.write("cut.mcap", bytes.substr(0, bytes.size() - 20));  // within the index
    for (const char* const command : {"info", "cat"})
        EXPECT_THAT(expect(1, {command, "cut.mcap"}).err, HasSubstr("error: [MCP002] the file ends without its index"));
    EXPECT_THAT(expect(1, {"recover", "cut.mcap", "-o", "all.mcap"}).out, StartsWith("all.mcap has 4 messages"));
    directory.write("cut.mcap", bytes.substr(0, bytes.find("oroforge.lost") - 100));  // within a chunk
    EXPECT_THAT(expect(1, {"info", "cut.mcap"}).err, HasSubstr("error: [MCP002] "));
    EXPECT_THAT(expect(1, {"cat", "cut.mcap"}).out, HasSubstr("\"height\": 1.5"));
    const Outcome outcome = expect(1, {"recover", "cut.mcap"});
    EXPECT_THAT(outcome.err, HasSubstr("cut.mcap: byte "));
    EXPECT_THAT(outcome.out, StartsWith("cut_recovered.mcap has "));
    EXPECT_EQ("", expect(0, {"info", "cut_recovered.mcap"}).err);
    EXPECT_THAT(expect(2, {"recover", "cut.mcap"}).err, HasSubstr("cut_recovered.mcap: error: the file exists"));
    expect(0, {"recover", "run.mcap", "-o", "whole.mcap"});
    EXPECT_EQ("", expect(0, {"diff", "run.mcap", "whole.mcap"}).out);
}

TEST_F(Tool, RefusesWhatIsNoRecording) {
    directory.write("table.mcap", "TimeStamp a b\n0 1 2\n");
    directory.write("empty.mcap", "");
    for (const char* const file : {"table.mcap", "empty.mcap"}) {
        for (const char* const command : {"info", "cat", "convert", "recover"})
            EXPECT_THAT(expect(2, {command, file}).err, HasSubstr(std::string(file) + ": byte 0: error: [MCP001]"));
        EXPECT_FALSE(std::filesystem::exists(directory / (std::string(file, 5) + "_recovered.mcap")));
    }
    EXPECT_THAT(expect(2, {"info", "none.mcap"}).err, HasSubstr("none.mcap: error: No such file or directory"));
    EXPECT_THAT(expect(2, {"info", "."}).err, HasSubstr(".: error: "));
    EXPECT_THAT(expect(2, {"show", "none.mcap"}).err, HasSubstr("oro-mcap --help explains the command line"));
    EXPECT_EQ(2, run({}).status);
    EXPECT_THAT(expect(0, {"--help"}).out, HasSubstr("recover"));
}

#ifdef ORO_PROGRAM
TEST_F(Tool, IsACommandOfOro) {
    record("run.mcap", messages());
    const auto runOro = [&](const std::string& program, std::vector<std::string> words) {
        Command command;
        command.program = program;
        words.insert(words.begin(), "mcap");
        command.arguments = words;
        command.directory = directory.path();
        return oroforge::test::run(command);
    };
    EXPECT_EQ(expect(0, {"cat", "run.mcap"}).out, runOro(ORO_PROGRAM, {"cat", "run.mcap"}).out);
    EXPECT_EQ(expect(0, {"--help"}).out, runOro(ORO_PROGRAM, {"--help"}).out);
    EXPECT_EQ(2, runOro(ORO_PROGRAM, {"info", "none.mcap"}).status);
    const std::filesystem::path alone = directory / "alone";
    std::filesystem::create_directory(alone);
    std::filesystem::copy(ORO_PROGRAM, alone / "oro");
    const Outcome missing = runOro((alone / "oro").string(), {"info", "run.mcap"});
    EXPECT_EQ(2, missing.status);
    EXPECT_THAT(missing.err,
                HasSubstr("alone/oro-mcap': the toolchain was built without recordings, for which it needs "
                          "libzstd-dev or liblz4-dev"));
}
#endif

TEST_F(Tool, ReportsMessagesThatDoNotFitTheirSchema) {
    std::vector<Told> wrong = messages();
    std::get<3>(wrong[0]).resize(20);
    std::get<3>(wrong[2]) = level(1, "x", 0);
    const std::uint32_t many = 0xffffffffU;  // points
    std::memcpy(&std::get<3>(wrong[2])[4 + 8 + 4 + 2 + 2], &many, sizeof many);
    record("run.mcap", wrong);
    const Outcome outcome = expect(1, {"cat", "run.mcap"});
    EXPECT_THAT(outcome.err, HasSubstr("[MCP012] topic '/tank/level': the message at 1.500000000 does not fit"));
    EXPECT_THAT(outcome.err, HasSubstr("a list of 4294967295 elements is longer than the rest"));
    EXPECT_EQ(2, std::count(outcome.out.begin(), outcome.out.end(), '\n'));
    std::string deep = "a/T1 p\n";
    for (int i = 1; i != 300; ++i)
        deep += "===\nMSG: a/T" + std::to_string(i) + "\na/T" + std::to_string(i + 1) + " p\n";
    deep += "===\nMSG: a/T300\n";
    // Lists of lists of nothing end with the message.
    record("run.mcap", messages(), "a/L[1000000000] p\n===\nMSG: a/L\na/E[9] p\n===\nMSG: a/E\n");
    EXPECT_THAT(expect(1, {"cat", "run.mcap"}).err, HasSubstr("a list of 1000000000 elements is longer than the rest"));
    record("run.mcap", messages(), "a/L[9] p\n===\nMSG: a/L\na/E[9] p\n===\nMSG: a/E\n");
    EXPECT_THAT(expect(1, {"cat", "run.mcap"}).err, HasSubstr("[MCP012] topic '/tank/level': the message at 1.5"));
    for (const auto& [schema, why] : std::vector<std::pair<std::string, std::string>>{
             {"float64\n", "line 1: found 'float64', expected a type and a name"},
             {"tank/Point p\n", "line 1: the type 'tank/Point' of the field 'p' is not described"},
             {"int8[0] p\n", "line 1: the brackets of 'int8[0]' have no valid number"},
             {"int8[99999999999] p\n", "line 1: the brackets of 'int8[99999999999]' have no valid number"},
             {deep, "types nest too deeply"},
             {"tank/P p\n===\nMSG: tank/P\ntank/P p\n", "a type contains itself"}}) {
        record("run.mcap", messages(), schema);
        EXPECT_THAT(expect(1, {"cat", "run.mcap"}).err, HasSubstr("[MCP012] topic '/tank/level': " + why));
    }
}

}  // namespace
