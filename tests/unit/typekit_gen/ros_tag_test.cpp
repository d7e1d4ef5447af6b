// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Structs with '@ros PACKAGE/NAME' in their comment: whether they are the message, and what becomes of it.
#include <cstdlib>

#include <support/golden.hpp>
#include <support/run_typegen.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

namespace {

class RosTag : public testing::Test {
protected:
    RosTag() {
        dir.write("ws/demo_msgs/package.xml", "<package><name>demo_msgs</name></package>");
        message("Point", "float64 x\nfloat64 y\nfloat64 z\n");
        message("Pose", "Point position\nPoint[2] more\n");
        ::setenv("ROS_PACKAGE_PATH", (dir / "ws").c_str(), 1);
        ::setenv("TYPEGEN_CACHE", "", 1);
    }
    ~RosTag() override { ::unsetenv("ROS_PACKAGE_PATH"); }

    void message(const std::string& name, const std::string& text) {
        dir.write("ws/demo_msgs/msg/" + name + ".msg", text);
    }
    /// With the structs in a header of their own; line 7 is the first.
    Ran typegen(const std::string& text, std::vector<std::string> more = {}) {
        dir.write("types.hpp",
                  "#pragma once\n#include <array>\n#include <cstdint>\n#include <string>\n#include <vector>\n"
                  "namespace t {\n" +
                      text + "\n}\n");
        std::vector<std::string> words = {"-o", (dir / "out").string(), "demo", (dir / "types.hpp").string()};
        words.insert(words.end(), more.begin(), more.end());
        return runTypegen(words);
    }
    std::string plugin() { return readTree(dir / "out")["Plugin.cpp"]; }
    void expectFine(const std::string& text, const std::string& name) {
        const Ran ran = typegen(text);
        EXPECT_EQ(ran.err, "");
        EXPECT_THAT(plugin(), HasSubstr("announceMessage(\"/t/A\", \"demo_msgs/" + name + "\""));
    }
    void expectFault(const std::string& text, const std::string& fault) {
        const Ran ran = typegen(text);
        EXPECT_EQ(ran.status, 1);
        EXPECT_THAT(ran.err, HasSubstr(fault));
    }

    const TempDir dir;
};

TEST_F(RosTag, withoutItNothingChanges) {
    EXPECT_EQ(typegen("/// A ros.\nstruct A { float x; };").err, "");
    EXPECT_THAT(plugin(), Not(HasSubstr("Message")));
}

TEST_F(RosTag, aMessageIsAnnounced) {
    expectFine("/// Where. @ros demo_msgs/Point\nstruct A { double x, y, z; };", "Point");
    EXPECT_THAT(plugin(), HasSubstr("#include <rtt/types/MessageNames.hpp>"));
    EXPECT_THAT(plugin(), HasSubstr("\"4a842b65f413084dc2b10fb484ea7f17\",\n      \"float64 x\\n\""));
    EXPECT_THAT(readTree(dir / "out")["types_types.cpp"], HasSubstr("\"Where.\""));
    expectFine("struct [[oro::ros(\"demo_msgs/Point\")]] A { double x, y, z; };", "Point");
}

TEST_F(RosTag, namesAndNestingDoNotMatter) {
    expectFine("/// @ros demo_msgs/Point\nstruct A { double a, b, c; };", "Point");
    expectFine("/// @ros demo_msgs/Point\nstruct A { std::array<double, 3> all; };", "Point");
    expectFine("/// @ros demo_msgs/Pose\nstruct A { double all[9]; };", "Pose");
    expectFine("struct P { double a[3]; };\n/// @ros demo_msgs/Pose\nstruct A { P one; P more[2]; };", "Pose");
    expectFine("struct P { double a[2]; };\n/// @ros demo_msgs/Pose\nstruct A { P some[4]; double last; };", "Pose");
    expectFine("struct B { double x; };\n/// @ros demo_msgs/Point\nstruct A : B { double y, z; };", "Point");
}

TEST_F(RosTag, everyKindOfField) {
    message("All",
            "bool a\nbyte b\nchar c\nint16 d\nuint64 e\nstring f\ntime g\nduration h\nPoint[] i\nstring[2] j\n"
            "int8 X=3\nuint8[0] none\nuint8 k\n");
    expectFine(
        "enum class Mode : std::uint8_t { Off };\n"
        "struct P { double x, y, z; };\nstruct Time { std::uint32_t s; std::int32_t n; };\n"
        "/// @ros demo_msgs/All\nstruct A {\n bool a; std::int8_t b; std::uint8_t c; short d; unsigned long e;\n"
        " std::string f; Time g, h; std::vector<P> i; std::string j[2]; [[oro::skip]] void* own; Mode k; };",
        "All");
}

TEST_F(RosTag, aWrongKindIsLocated) {
    expectFault("/// @ros demo_msgs/Point\nstruct A {\n  double x;\n  float y;\n  double z;\n};",
                "types.hpp:10:9: error: [TK081] 't::A' is not 'demo_msgs/Point': field 'y' is float32, the message has "
                "float64 there, 'y'");
    message("Flag", "uint8 x\n");
    expectFault("/// @ros demo_msgs/Flag\nstruct A { bool x; };", "field 'x' is bool, the message has uint8 there");
    message("List", "float64[] x\n");
    expectFault("/// @ros demo_msgs/List\nstruct A { double x[3]; };",
                "field 'x' is float64, the message has a list of any length there, 'x'");
    expectFault("/// @ros demo_msgs/List\nstruct A { std::vector<float> x; };",
                "field 'x[]' is float32, the message has float64 there, 'x[]'");
}

TEST_F(RosTag, allDifferencesAreTold) {
    const Ran ran =
        typegen("/// @ros demo_msgs/Pose\nstruct A { float a; double b; int c; float d[3]; double e[3]; };");
    for (const char* field : {"'a' is float32", "'c' is int32", "'d' is float32"})
        EXPECT_THAT(ran.err, HasSubstr(field));
    EXPECT_THAT(ran.err, Not(HasSubstr("'b' is")));
    EXPECT_THAT(ran.err, HasSubstr("Point.msg:1:1: note: this is the field of the message"));
}

TEST_F(RosTag, aWrongCountIsLocated) {
    expectFault("/// @ros demo_msgs/Point\nstruct A { double x, y; };",
                "types.hpp:8:8: error: [TK081] 't::A' is not 'demo_msgs/Point': nothing for field 'z' of the message");
    expectFault(
        "/// @ros demo_msgs/Point\nstruct A { double x, y, z, w; };",
        "types.hpp:8:28: error: [TK081] 't::A' is not 'demo_msgs/Point': field 'w' is more than the message has");
    message("Nine", "float64[9] x\n");
    expectFault("/// @ros demo_msgs/Nine\nstruct A { double x[8]; };",
                "field 'x' is an array of 8, the message has one of 9 there, 'x'");
}

TEST_F(RosTag, hugeArraysTakeNoTime) {
    message("Huge", "Point[200000000] x\nuint8[200000000] y\n");
    expectFine(
        "struct P { double x, y, z; };\n/// @ros demo_msgs/Huge\nstruct A { P x[200000000]; std::uint8_t "
        "y[100000000], z[100000000]; };",
        "Huge");
    expectFault("struct P { double x, y; };\n/// @ros demo_msgs/Huge\nstruct A { P x[100000000]; };", "TK081");
}

TEST_F(RosTag, missingMessagesSayWhereWasSearched) {
    expectFault("/// @ros no_such_msgs/Point\nstruct A { double x; };",
                "types.hpp:8:8: error: [RM006] 'no_such_msgs/Point': no package 'no_such_msgs' with .msg files; "
                "searched: " +
                    (dir / "ws").string());
    expectFault("/// @ros no_such_msgs/Point\nstruct A { double x; };", "(Debian: ros-no-such-msgs)");
    expectFault("/// @ros demo_msgs/Pint\nstruct A { double x; };", "did you mean 'Point'?");
}

TEST_F(RosTag, circles) {
    message("Loop", "Loop[] next\n");
    expectFault("/// @ros demo_msgs/Loop\nstruct A { double x; };", "[RM007] a 'demo_msgs/Loop' contains itself");
    message("List", "Point[] all\n");
    expectFault("/// @ros demo_msgs/List\nstruct A { std::vector<A> all; };",
                "field 'all[]' cannot be in a message: a 't::A' is in itself");
}

TEST_F(RosTag, theSumIsChecked) {
    expectFine("/// @ros demo_msgs/Point 4a842b65f413084dc2b10fb484ea7f17\nstruct A { double x, y, z; };", "Point");
    expectFault("/// @ros demo_msgs/Point 0a\nstruct A { double x, y, z; };",
                "[TK082] 't::A' is to be 'demo_msgs/Point' with the MD5 sum 0a, but the one of ");
}

TEST_F(RosTag, whatIsNoMessage) {
    expectFault("/// @ros Point\nstruct A { double x; };", "[TK080] '@ros Point' of 't::A' does not name a message");
    expectFault("/// @ros\nstruct A { double x; };", "[TK080] '@ros' of 't::A' does not name a message");
    expectFault("/// @ros ../x/Point\nstruct A { double x; };", "does not name a message");
    expectFault("/// @ros demo_msgs/Point\nstruct A { const double x = 0; double y, z; };",
                "[TK080] 't::A' cannot be the message 'demo_msgs/Point': its values cannot go over ports");
    expectFault("/// @ros demo_msgs/Point\nenum A { B };", "[TK080] enum 't::A' cannot be a message of ROS");
    expectFault("struct A {\n  double x;  ///< @ros demo_msgs/Point\n};",
                "types.hpp:8:10: error: [TK080] field 'x' of");
}

TEST_F(RosTag, anotherOrderIsLikelyToBeAMistake) {
    message("Rotation", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n");
    const Ran ran = typegen("/// @ros demo_msgs/Rotation\nstruct A { double w, x, y, z; };");
    EXPECT_EQ(ran.status, 0);
    EXPECT_THAT(ran.err, HasSubstr("types.hpp:8:19: warning: [TK083] field 'w' of 't::A' is where 'demo_msgs/Rotation' "
                                   "has 'x'; its own 'w' is elsewhere"));
    message("Two", "Point one\nPoint other\n");
    expectFine("struct P { double x, y, z; };\n/// @ros demo_msgs/Two\nstruct A { P other, one; };", "Two");
}

TEST_F(RosTag, theFilesOfTheMessagesAreInputs) {
    const std::string depfile = (dir / "depfile").string();
    EXPECT_EQ(typegen("/// @ros demo_msgs/Pose\nstruct A { double x[9]; };", {"--depfile", depfile}).err, "");
    const std::string text = readTree(dir.path())["depfile"];
    EXPECT_THAT(text, HasSubstr("demo_msgs/msg/Pose.msg"));
    EXPECT_THAT(text, HasSubstr("demo_msgs/msg/Point.msg"));
}

TEST_F(RosTag, aChangedMessageIsReadAgain) {
    ::setenv("TYPEGEN_CACHE", (dir / "cache").c_str(), 1);
    EXPECT_EQ(typegen("/// @ros demo_msgs/Point\nstruct A { double x, y, z; };").err, "");
    message("Point", "float32 x\n");
    expectFault("/// @ros demo_msgs/Point\nstruct A { double x, y, z; };", "TK081");
    ::setenv("TYPEGEN_CACHE", "", 1);
}

}  // namespace
