// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the player makes of recordings: whole, damaged and from others.
#include "replay_fixture.hpp"

#include <reporting/mcap/in_order.hpp>

#include <algorithm>
#include <cstring>

namespace {

using namespace replay_test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kFloat = "float64 data\n";

class PlayerOf : public Replay {
protected:
    /** 100 samples of two ports, in chunks of a few. */
    void recordNumbers() {
        set("ChunkSize", 4096U);
        ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->reportPort("Machine", "levels"));
        ASSERT_TRUE(recorder->start());
        for (int i = 0; i != 100; ++i) {
            machine.speed.write(i);
            machine.levels.write(std::vector<double>(40, i));
            step();
        }
        recorder->stop();
    }
    std::string bytes() const { return oroforge::test::readFile(directory / "run.mcap"); }
};

TEST_F(PlayerOf, AllTypesRepeatsTheValues) {
    ASSERT_TRUE(recorder->reportComponent("Machine") && recorder->reportPort("Machine", "motor.current"));
    ASSERT_TRUE(recorder->reportData("Machine", "gain"));
    set("States", true);
    ASSERT_TRUE(recorder->start());
    sample::Tank tank;
    tank.label = "blue";
    tank.path = {{1, 2}, {3, 4}};
    tank.levels.assign(100, 1.5);
    tank.flags = {true, false};
    tank.mode = sample::Mode::Draining;
    machine.tank.write(tank);
    machine.speed.write(2.5);
    machine.mode.write(sample::Mode::Filling);
    machine.current.write(0.25F);
    machine.levels.write(std::vector<double>());
    step();
    machine.levels.write(std::vector<double>(100000, 3));
    step();
    recorder->stop();

    const auto player = open();
    ASSERT_TRUE(player) << error;
    std::vector<std::string> names;
    for (const auto& one : player->topics()) names.push_back(one.component + ":" + one.port + ":" + one.type);
    EXPECT_THAT(names, testing::UnorderedElementsAre("Machine:speed:double", "Machine:place:/sample/Point",
                                                     "Machine:levels:array", "Machine:tank:/sample/Tank",
                                                     "Machine:mode:/sample/Mode", "Machine:motor.current:float"));
    EXPECT_EQ("component", player->metadata().at("clock"));
    Reader<sample::Tank> tanks(port(*player, "/Machine/tank"));
    Reader<double> speeds(port(*player, "/Machine/speed"));
    Reader<sample::Mode> modes(port(*player, "/Machine/mode"));
    Reader<float> currents(port(*player, "/Machine/motor/current"));
    Reader<std::vector<double>> levels(port(*player, "/Machine/levels"));
    EXPECT_EQ("current", port(*player, "/Machine/motor/current")->getName());
    EXPECT_THAT(play(*player), SizeIs(2));
    EXPECT_THAT(speeds.all(), ElementsAre(2.5));
    EXPECT_THAT(modes.all(), ElementsAre(sample::Mode::Filling));
    EXPECT_THAT(currents.all(), ElementsAre(0.25F));
    EXPECT_EQ((std::vector<std::vector<double>>{{}, std::vector<double>(100000, 3)}), levels.all());
    const auto all = tanks.all();
    ASSERT_THAT(all, SizeIs(1));
    EXPECT_EQ("blue", all[0].label);
    EXPECT_EQ(4, all[0].path.at(1).y);
    EXPECT_EQ(tank.levels, all[0].levels);
    EXPECT_EQ(tank.flags, all[0].flags);
    EXPECT_EQ(sample::Mode::Draining, all[0].mode);
    EXPECT_THAT(player->problems(), IsEmpty());
    EXPECT_FALSE(player->port("/Machine/gain", error));
    EXPECT_THAT(error, HasSubstr("run.mcap: error: [MCP020] topic '/Machine/gain': the recording has no such port"));
}

TEST_F(PlayerOf, OnePortSkipsTheOthersAndHasTheirTimes) {
    recordNumbers();
    const auto player = open();
    ASSERT_TRUE(player) << error;
    EXPECT_EQ(100U, player->topics()[0].count);
    EXPECT_FALSE(player->next());  // nothing has a port yet
    Reader<double> speeds(port(*player, "/Machine/speed"));
    const auto times = play(*player);
    ASSERT_THAT(times, SizeIs(100));
    EXPECT_EQ(10000000, times[1] - times[0]);
    const auto all = speeds.all();
    ASSERT_THAT(all, SizeIs(100));
    EXPECT_EQ(99, all[99]);
}

TEST_F(PlayerOf, APortThatIsAskedForLaterGoesOnFromThere) {
    recordNumbers();
    const auto player = open();
    ASSERT_TRUE(player) << error;
    Reader<double> speeds(port(*player, "/Machine/speed"));
    for (int i = 0; i != 40; ++i) {
        ASSERT_TRUE(player->next());
        player->deliver();
    }
    ASSERT_TRUE(player->next());
    Reader<std::vector<double>> levels(port(*player, "/Machine/levels"));
    EXPECT_THAT(play(*player), SizeIs(60));
    EXPECT_THAT(speeds.all(), SizeIs(100));
    EXPECT_THAT(levels.all(), SizeIs(60));
}

TEST_F(PlayerOf, ACutFileRepeatsWhatIsThere) {
    recordNumbers();
    const std::string whole = bytes();
    std::size_t most = 0;
    for (std::size_t part = 1; part != 20; ++part) {
        directory.write("cut.mcap", whole.substr(0, whole.size() * part / 20));
        const auto player = open("cut.mcap");
        if (!player) {
            EXPECT_THAT(error, HasSubstr("cut.mcap: byte "));
            continue;
        }
        Reader<double> speeds(port(*player, "/Machine/speed"));
        (void)play(*player);
        const auto all = speeds.all();
        for (std::size_t i = 0; i != all.size(); ++i) EXPECT_EQ(i, all[i]);
        EXPECT_GE(all.size(), most);
        most = all.size();
        ASSERT_FALSE(player->problems().empty());
        EXPECT_THAT(player->problems()[0], testing::AnyOf(HasSubstr("[MCP002]"), HasSubstr("[MCP008]")));
    }
    EXPECT_GT(most, 60U);
}

TEST_F(PlayerOf, ADamagedFileLeavesThePartOut) {
    recordNumbers();
    for (const bool hasIndex : {true, false}) {
        std::string damaged = bytes();
        damaged[damaged.size() / 2] = static_cast<char>(~damaged[damaged.size() / 2]);
        if (!hasIndex) damaged.resize(damaged.size() - 100);
        directory.write("damaged.mcap", damaged);
        const auto player = open("damaged.mcap");
        ASSERT_TRUE(player) << error;
        Reader<double> speeds(port(*player, "/Machine/speed"));
        (void)play(*player);
        const auto all = speeds.all();
        EXPECT_LT(all.size(), 100U);
        EXPECT_GT(all.size(), 60U);
        EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
        EXPECT_THAT(player->problems(), testing::Contains(testing::MatchesRegex(
                                            ".*damaged.mcap: byte [0-9]+: error: \\[MCP003\\] the checksum .*")));
    }
}

TEST_F(PlayerOf, NoRecordingSaysWhy) {
    directory.write("empty.mcap", "");
    EXPECT_FALSE(open("empty.mcap"));
    EXPECT_THAT(error, HasSubstr("empty.mcap: byte 0: error: [MCP001] this is not an MCAP file"));
    EXPECT_FALSE(open("none.mcap"));
    EXPECT_THAT(error, HasSubstr("none.mcap: error: [MCP010] the recording cannot be read: No such file"));
    OtherFile nothing;
    write("nothing.mcap", nothing);
    EXPECT_FALSE(open("nothing.mcap"));
    OtherFile values;
    (void)values.topic("/Machine/gain", "std_msgs/msg/Float64", kFloat, {{"oroforge.kind", "value"}});
    (void)values.topic("/rosout", "rcl_interfaces/msg/Log", "string msg\n");
    write("values.mcap", values);
    EXPECT_FALSE(open("values.mcap"));
    EXPECT_THAT(error, HasSubstr("values.mcap: error: [MCP020] the recording has no port"));
}

TEST_F(PlayerOf, AnotherRecorderHasItsNamesAndNumbers) {
    OtherFile other;
    const auto chatter = other.topic("/chatter", "std_msgs/msg/String", "string data\n");
    const auto speed = other.topic("/arm/joint/speed", "std_msgs/msg/Float64", "# in m/s\nfloat64 data  # fast\n");
    const auto count = other.topic("arm/count", "std_msgs/msg/Int32", "int32 MOST=7\nint32 data\n");
    const auto place = other.topic("/place", "sample/msg/Point", "float64 x\nfloat64 y\n");
    other.message(speed, 2000, Cdr().put(1.5));
    other.message(chatter, 1000, Cdr().put("hello"));
    other.message(count, 2000, Cdr().put(std::int32_t(-3)));
    // Big endian, as some do it, and filled up.
    other.message(count, 3000, {0, 0, 0, 0, 0, 0, 1, 2});
    std::vector<unsigned char> filled = Cdr().put("abc").put(std::uint8_t(0)).put(std::uint8_t(0)).bytes;
    other.message(chatter, 4000, filled);
    other.message(place, 5000, Cdr().put(1.0).put(2.0));
    write("other.mcap", other);
    const auto player = open("other.mcap");
    ASSERT_TRUE(player) << error;
    std::vector<std::string> names;
    for (const auto& one : player->topics()) names.push_back(one.component + ":" + one.port);
    EXPECT_THAT(names, ElementsAre(":chatter", "arm:joint.speed", "arm:count", ":place"));
    EXPECT_EQ(2U, player->topics()[0].count);
    Reader<std::string> texts(port(*player, "/chatter"));
    Reader<double> speeds(port(*player, "/arm/joint/speed"));
    Reader<int> counts(port(*player, "arm/count"));
    Reader<sample::Point> places(port(*player, "/place"));
    EXPECT_THAT(play(*player), ElementsAre(1000, 2000, 3000, 4000, 5000));
    EXPECT_THAT(texts.all(), ElementsAre("hello", "abc"));
    EXPECT_THAT(speeds.all(), ElementsAre(1.5));
    EXPECT_THAT(counts.all(), ElementsAre(-3, 258));
    ASSERT_THAT(places.all(), SizeIs(1));
    EXPECT_THAT(player->problems(), IsEmpty());  // it need not have an index
}

TEST_F(PlayerOf, TwoTopicsAtOneTimeKeepTheOrderOfTheFile) {
    OtherFile other;
    const auto first = other.topic("/a/first", "std_msgs/msg/Int32", "int32 data\n");
    const auto second = other.topic("/a/second", "std_msgs/msg/Int32", "int32 data\n");
    other.message(second, 7, Cdr().put(1));
    other.message(first, 7, Cdr().put(2));
    other.message(second, 5, Cdr().put(0));
    write("other.mcap", other);
    const auto player = open("other.mcap");
    ASSERT_TRUE(player) << error;
    // Both write to one reader, whose buffer has the order.
    RTT::InputPort<int> reader("reader");
    const RTT::ConnPolicy policy = RTT::ConnPolicy::buffer(10);
    RTT::ConnPolicy shared = policy;
    shared.buffer_policy = RTT::PerInputPort;
    ASSERT_TRUE(port(*player, "/a/first")->connectTo(&reader, shared));
    ASSERT_TRUE(port(*player, "/a/second")->connectTo(&reader, shared));
    EXPECT_THAT(play(*player), ElementsAre(5, 7));
    std::vector<int> all;
    for (int value = 0; reader.read(value) == RTT::NewData;) all.push_back(value);
    EXPECT_THAT(all, ElementsAre(0, 1, 2));
}

TEST_F(PlayerOf, MessagesThatDoNotFitAreLeftOut) {
    OtherFile other;
    const auto text = other.topic("/text", "std_msgs/msg/String", "string data\n");
    other.message(text, 1, {0, 1, 0, 0, 255, 255, 255, 255});
    other.message(text, 2, std::vector<unsigned char>());
    other.message(text, 3, Cdr().put("good"));
    other.message(text, 4, {0, 3, 0, 0, 1, 0, 0, 0, 0});  // with a list of parameters
    write("other.mcap", other);
    const auto player = open("other.mcap");
    ASSERT_TRUE(player) << error;
    Reader<std::string> texts(port(*player, "/text"));
    EXPECT_THAT(play(*player), SizeIs(4));
    EXPECT_THAT(texts.all(), ElementsAre("good"));
    ASSERT_THAT(player->problems(), SizeIs(1));
    EXPECT_THAT(
        player->problems()[0],
        testing::MatchesRegex(".*other.mcap: error: \\[MCP025\\] topic '/text': the message at 0.000000001 does "
                              "not fit its type: byte .* \\(and 2 more\\)"));
}

TEST_F(PlayerOf, TwoChannelsOfOneTopicShareAPort) {
    OtherFile other;
    const auto one = other.topic("/number", "std_msgs/msg/Int32", "int32 data\n");
    const auto two = other.topic("/number", "std_msgs/msg/Int32", "int32 data\n");
    other.message(one, 1, Cdr().put(1));
    other.message(two, 2, Cdr().put(2));
    const auto mixed = other.topic("/mixed", "std_msgs/msg/Int32", "int32 data\n");
    (void)other.topic("/mixed", "std_msgs/msg/Float64", kFloat);
    other.message(mixed, 3, Cdr().put(3));
    write("other.mcap", other);
    const auto player = open("other.mcap");
    ASSERT_TRUE(player) << error;
    ASSERT_THAT(player->topics(), SizeIs(2));
    Reader<int> numbers(port(*player, "/number"));
    EXPECT_FALSE(player->port("/mixed", error));
    EXPECT_THAT(error, HasSubstr("[MCP023] topic '/mixed': its messages have the types 'int' and 'double'"));
    EXPECT_THAT(play(*player), ElementsAre(1, 2));
    EXPECT_THAT(numbers.all(), ElementsAre(1, 2));
}

TEST_F(PlayerOf, AnIndexWithWrongTimesNeverGoesBack) {
    recordNumbers();
    const std::string wrong = bytes();
    oroforge::mcap::MemorySource source(reinterpret_cast<const unsigned char*>(wrong.data()), wrong.size());
    oroforge::mcap::Summary summary;
    ASSERT_FALSE(readSummary(source, summary));
    ASSERT_GT(summary.chunks.size(), 3U);
    std::vector<oroforge::mcap::Piece> pieces = oroforge::mcap::namedPieces(summary);
    ASSERT_EQ(summary.chunks.size(), pieces.size());
    pieces[0].start = pieces[3].end;
    oroforge::mcap::ChannelIds known;
    known.insertAll();
    oroforge::mcap::InOrder messages(source, pieces, known, {}, [](const oroforge::mcap::Problem&) { FAIL(); });
    std::size_t count = 0;
    while (messages.next()) ++count;
    EXPECT_EQ(200U, count);
}

/** Where the entries of the index begin that a file has of its chunks; and takes away the checksum that covers them. */
std::vector<std::size_t> openIndex(std::string& file) {
    const auto number = [&file](std::size_t at) {
        std::uint64_t read = 0;
        std::memcpy(&read, file.data() + at, sizeof read);
        return static_cast<std::size_t>(read);
    };
    constexpr std::size_t kHead = 1 + 8;  // of a record
    const std::size_t footer = file.size() - sizeof oroforge::mcap::kMagic - 20;
    std::vector<std::size_t> entries;
    for (std::size_t at = number(footer); at < footer - kHead; at += kHead + number(at + 1))
        if (file[at] == static_cast<char>(oroforge::mcap::Op::ChunkIndex)) entries.push_back(at + kHead);
    std::memset(&file[footer + 16], 0, 4);
    return entries;
}

TEST_F(PlayerOf, MessagesOfATimeThatIsOverAreReplayedLateAndReported) {
    recordNumbers();
    std::string wrong = bytes();
    const std::vector<std::size_t> entries = openIndex(wrong);
    ASSERT_GT(entries.size(), 3U);
    wrong.replace(entries[0], 16, wrong.substr(entries[3], 16));  // first and last time
    directory.write("wrong.mcap", wrong);
    const auto player = open("wrong.mcap");
    ASSERT_TRUE(player) << error;
    Reader<double> speeds(port(*player, "/Machine/speed"));
    (void)play(*player);
    EXPECT_THAT(speeds.all(), SizeIs(100));
    EXPECT_THAT(player->problems(), testing::Contains(HasSubstr("[MCP026] a message at ")));
}

TEST_F(PlayerOf, AnIndexThatNamesNoChunkIsReported) {
    recordNumbers();
    std::string wrong = bytes();
    const std::vector<std::size_t> entries = openIndex(wrong);
    ASSERT_GT(entries.size(), 3U);
    wrong.replace(entries[1] + 16, 8, std::string(8, '\1'));  // the offset
    directory.write("wrong.mcap", wrong);
    const auto player = open("wrong.mcap");
    ASSERT_TRUE(player) << error;
    Reader<double> speeds(port(*player, "/Machine/speed"));
    (void)play(*player);
    EXPECT_THAT(speeds.all(), SizeIs(100));  // those that a reader of the whole file finds
    EXPECT_THAT(player->problems(), testing::Contains(HasSubstr("[MCP008] the index names a chunk here")));
}

}  // namespace
