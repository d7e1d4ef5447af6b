// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Recorded types that are not the loaded ones: what is said of them, and what `tolerate` makes of them.
#include "replay_fixture.hpp"

namespace {

using namespace replay_test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/** The tank as it was before: `name` for `label`, a number of another kind, and points with a third coordinate. */
constexpr const char* kOldTank =
    "float64[] levels\n"
    "old/Point[] path\n"
    "string name\n"
    "int64 id\n"
    "float64[3] weights\n"
    "uint8 mode\n"
    "old/Point position\n"
    "================================================================================\n"
    "MSG: old/Point\n"
    "float64 y\n"
    "uint8 z\n";

Cdr oldTank() {
    Cdr bytes;
    bytes.put(std::uint32_t(2)).put(1.5).put(2.5);
    bytes.put(std::uint32_t(3));
    for (int i = 0; i != 3; ++i) bytes.put(10.0 + i).put(std::uint8_t(9));
    bytes.put("a name")
        .put(std::int64_t(77))
        .put(1.0)
        .put(2.0)
        .put(3.0)
        .put(std::uint8_t(7))
        .put(5.0)
        .put(std::uint8_t(1));
    return bytes;
}

class RecordedTypes : public Replay {
protected:
    /** A file with one topic of points, described like this. */
    std::unique_ptr<Player> points(const std::string& text, bool tolerate, const Cdr& message,
                                   const std::string& language = "ros2msg") {
        OtherFile other;
        const auto id =
            other.topic("/place", language == "ros2msg" ? "sample/msg/Point" : "sample::Point", text,
                        {{"oroforge.type", "/sample/Point"}, {"oroforge.fingerprint", "0123456789abcdef"}}, language);
        other.message(id, 1, message);
        write("points.mcap", other);
        return open("points.mcap", tolerate);
    }
    /** Why there is no port. */
    std::string refusal(const std::string& text, bool tolerate = false, const std::string& language = "ros2msg") {
        const auto player = points(text, tolerate, Cdr(), language);
        EXPECT_TRUE(player) << error;
        std::string problem;
        EXPECT_FALSE(player && player->port("/place", problem));
        return problem;
    }
};

TEST_F(RecordedTypes, WithTheSameFieldsAreTaken) {
    const Cdr message = Cdr().put(1.0).put(2.0);
    const char* const idl = "module sample { struct Point { double x; double y; }; };";
    for (const auto& [language, text] :
         {std::pair<const char*, const char*>{"ros2msg", "float64 x\nfloat64 y\n"}, {"omgidl", idl}}) {
        const auto player = points(text, false, message, language);
        ASSERT_TRUE(player) << error;
        Reader<sample::Point> reader(port(*player, "/place"));
        EXPECT_THAT(play(*player), SizeIs(1));
        const auto all = reader.all();
        ASSERT_THAT(all, SizeIs(1)) << language;
        EXPECT_EQ(2.0, all[0].y);
    }
}

TEST_F(RecordedTypes, ThatDifferAreRefusedByTheirFields) {
    EXPECT_THAT(refusal("float64 x\n"),
                HasSubstr("points.mcap: error: [MCP023] topic '/place': the loaded type "
                          "'/sample/Point' is not the recorded one: the field 'y' is not recorded"));
    EXPECT_THAT(refusal("float64 x\nfloat64 y\nfloat64 z\n"),
                HasSubstr("the field 'z' is recorded, but not in the loaded type"));
    EXPECT_THAT(refusal("float32 x\nint8[] y\n"),
                HasSubstr("the field 'x' is float64, and was recorded as float32; the field 'y' is float64, and was "
                          "recorded as int8[]"));
    EXPECT_THAT(refusal("float64 y\nfloat64 x\n"), HasSubstr("the fields have another order"));
    EXPECT_THAT(refusal("float64 a\nfloat64 b\nfloat64 c\n"), HasSubstr("the field 'a' is recorded, but not in the "
                                                                        "loaded type; and 2 more"));
    EXPECT_THAT(refusal("module sample { struct Point { double x; float y; }; };", false, "omgidl"),
                HasSubstr("the field 'y' is float64, and was recorded as float32"));
    EXPECT_THAT(refusal("what is this"),
                HasSubstr("[MCP023] topic '/place': the description of its type cannot be read"));
    EXPECT_THAT(refusal("syntax = \"proto3\";", false, "protobuf"), HasSubstr("'protobuf'"));
}

TEST_F(RecordedTypes, WithNothingInCommonAreRefusedAnyway) {
    EXPECT_THAT(refusal("float64 a\n", true), HasSubstr("[MCP023]"));
}

TEST_F(RecordedTypes, InAnotherEncodingAreRefused) {
    OtherFile other;
    (void)other.topic("/a", "std_msgs/msg/Float64", "float64 data\n", {}, "ros2msg", "ros1");
    write("other.mcap", other);
    const auto player = open("other.mcap", true);
    ASSERT_TRUE(player) << error;
    EXPECT_FALSE(player->port("/a", error));
    EXPECT_THAT(error, HasSubstr("[MCP022] topic '/a': its messages are encoded as 'ros1', and only cdr is replayed"));
}

TEST_F(RecordedTypes, ThatAreNotLoadedAreRefused) {
    OtherFile other;
    (void)other.topic("/a", "tank/msg/Unknown", "float64 x\n");
    (void)other.topic("/b", "tank/msg/Unknown", "float64 x\n", {{"oroforge.type", "/tank/Unknown"}});
    write("other.mcap", other);
    const auto player = open("other.mcap", true);
    ASSERT_TRUE(player) << error;
    EXPECT_FALSE(player->port("/a", error));
    EXPECT_THAT(error, HasSubstr("[MCP021] topic '/a': its type 'tank/msg/Unknown' is not loaded; import the typekit"));
    EXPECT_FALSE(player->port("/b", error));
    EXPECT_THAT(error, HasSubstr("its type '/tank/Unknown' is not loaded"));
    EXPECT_FALSE(player->next());
}

TEST_F(RecordedTypes, OfOneMoreFieldAreSkippedThere) {
    const auto player = points("float64 x\nstring[] z\nfloat64 y\n", true,
                               Cdr().put(1.0).put(std::uint32_t(2)).put("one").put("more").put(2.0));
    ASSERT_TRUE(player) << error;
    Reader<sample::Point> reader(port(*player, "/place"));
    EXPECT_THAT(error,
                AllOf(HasSubstr("[MCP024]"), HasSubstr("the field 'z' is recorded, but not in the loaded type")));
    (void)play(*player);
    const auto all = reader.all();
    ASSERT_THAT(all, SizeIs(1));
    EXPECT_EQ(1.0, all[0].x);
    EXPECT_EQ(2.0, all[0].y);
}

TEST_F(RecordedTypes, KeepDefaultsAndSkipAtEveryDepth) {
    OtherFile other;
    const auto id = other.topic("/tank", "sample/msg/Tank", kOldTank, {{"oroforge.type", "/sample/Tank"}});
    for (std::uint64_t time = 1; time != 4; ++time) other.message(id, time, oldTank());
    std::vector<unsigned char> cut = oldTank().bytes;
    cut.resize(cut.size() - 20);
    other.message(id, 4, cut);
    write("tanks.mcap", other);
    ASSERT_TRUE(open("tanks.mcap"));
    EXPECT_FALSE(open("tanks.mcap")->port("/tank", error));
    EXPECT_THAT(error,
                HasSubstr("the field 'id' is int32, and was recorded as int64; the field 'label' is not recorded; "
                          "the field 'position.x' is not recorded; and "));
    const auto player = open("tanks.mcap", true);
    Reader<sample::Tank> reader(port(*player, "/tank"));
    EXPECT_THAT(play(*player), SizeIs(4));
    const auto all = reader.all();
    ASSERT_THAT(all, SizeIs(3));
    for (const sample::Tank& tank : all) {
        EXPECT_THAT(tank.levels, ElementsAre(1.5, 2.5));
        ASSERT_THAT(tank.path, SizeIs(3));
        EXPECT_EQ(12.0, tank.path[2].y);
        EXPECT_EQ(0.0, tank.path[2].x);
        EXPECT_EQ(5.0, tank.position.y);
        EXPECT_EQ(3.0, tank.weights[2]);
        EXPECT_EQ(sample::Mode::Draining, tank.mode);
        EXPECT_EQ("", tank.label);
        EXPECT_EQ(0, tank.id);
        EXPECT_THAT(tank.flags, IsEmpty());
    }
    EXPECT_THAT(player->problems(), ElementsAre(HasSubstr("[MCP025] topic '/tank': the message at 0.000000004")));
}

TEST_F(RecordedTypes, OfAnyLengthNeverReadBeyondTheMessage) {
    const std::vector<unsigned char> whole = oldTank().bytes;
    OtherFile other;
    const auto id = other.topic("/tank", "sample/msg/Tank", kOldTank, {{"oroforge.type", "/sample/Tank"}});
    std::uint64_t time = 0;
    for (std::size_t size = 0; size != whole.size(); ++size)
        other.message(id, ++time, std::vector<unsigned char>(whole.begin(), whole.begin() + static_cast<long>(size)));
    for (std::size_t at = 0; at != whole.size(); ++at)
        for (const unsigned char with : {0x00, 0x7f, 0xff}) {
            std::vector<unsigned char> changed = whole;
            changed[at] = with;
            other.message(id, ++time, changed);
        }
    write("tanks.mcap", other);
    const auto player = open("tanks.mcap", true);
    ASSERT_TRUE(player) << error;
    Reader<sample::Tank> reader(port(*player, "/tank"));
    EXPECT_EQ(time, play(*player).size());
    EXPECT_GT(reader.all().size(), whole.size());
}

}  // namespace
