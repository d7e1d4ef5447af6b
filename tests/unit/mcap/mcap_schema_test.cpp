// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Messages are taken apart by the texts that describe their types.
#include "cdr_bytes.hpp"

#include <reporting/schema/message_schema.hpp>

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

namespace {

using mcap_test::Cdr;
using oroforge::schema::MessageSchema;
using oroforge::schema::PartTaker;
using testing::HasSubstr;

/** "{a: 1, b: [2, 3]}" */
struct Shown : PartTaker {
    std::string all;
    void separate() {
        if (!all.empty() && all.back() != '{' && all.back() != '[' && all.back() != ' ') all += ", ";
    }
    void beginStruct() override { all += '{'; }
    void field(std::string_view name) override {
        separate();
        all += std::string(name) + ": ";
    }
    void endStruct() override { all += '}'; }
    void beginList() override { all += '['; }
    void element(std::size_t) override { separate(); }
    void endList() override { all += ']'; }
    void number(std::string_view text) override { all += text; }
    void text(std::string_view text) override { all += "'" + std::string(text) + "'"; }
};

std::string walked(const std::string& name, const std::string& text, const Cdr& cdr,
                   const std::string& encoding = "omgidl") {
    MessageSchema schema;
    std::string why;
    if (!schema.read(encoding, name, text, why)) return why;
    Shown shown;
    if (!schema.walk(cdr.bytes.data(), cdr.bytes.size(), shown, why)) return why;
    return shown.all;
}

std::string refusal(const std::string& text, const std::string& encoding = "omgidl", const std::string& name = "T") {
    MessageSchema schema;
    std::string why;
    return schema.read(encoding, name, text, why) ? "it is read" : why;
}

TEST(McapSchema, IdlOfTheRecorder) {
    const char* const text =
        "module tank_Mode_values {\n"
        "  const int8 IDLE = -1;  // Nothing moves.\n"
        "};\n"
        "module oroforge {\nstruct Nothing {\n};\n};\n"
        "module tank {\n"
        "union Either switch (uint32) {\n"
        "  case 0: oroforge::Nothing nothing;\n"
        "  case 1: double number;\n"
        "  case 2: string text;\n"
        "};\n};\n"
        "module tank {\n"
        "struct Level {\n"
        "  double angleRad;  // The angle. [rad]\n"
        "  int8 mode;\n"
        "  sequence<tank::Either> values;\n"
        "  int16 _string[2];\n"
        "  boolean isOpen;\n"
        "};\n};\n";
    Cdr cdr;
    cdr.put(0.5).put(std::int8_t(-1)).put(std::uint32_t(3));
    cdr.put(std::uint32_t(0)).put(std::uint32_t(1)).put(2.5).put(std::uint32_t(2)).put("wet");
    cdr.put(std::int16_t(7)).put(std::int16_t(-8)).put(true);
    EXPECT_EQ(
        "{angleRad: 0.5, mode: -1, values: [{nothing: {}}, {number: 2.5}, {text: 'wet'}], string: [7, -8], isOpen: "
        "true}",
        walked("tank::Level", text, cdr));
    EXPECT_EQ("the text does not describe the type 'tank::Mode'", walked("tank::Mode", text, cdr));
}

TEST(McapSchema, IdlOfOthers) {
    const char* const text = R"(
#include "other.idl"
#pragma once
/* two
   lines */
const long kRows = (1 << 1) | 0x2 - 1;
const string kName = "a; b" "c";
const double kPi = 3.1e+0;
module a {
  module b {
    enum Color { RED, @value(5) GREEN = 5, BLUE };
    @bit_bound(8) enum Small { ON, OFF };
    typedef sequence<long, kRows * 2> Longs;
    typedef Longs Table[kRows];
    struct Later;
    @final struct Base { @key unsigned long id; };
  };
  @verbatim(language="comment", text="it says \")\"" "\n")
  @mutable
  union Which switch (b::Color) {
    case RED: case b::GREEN: @unit("m") float length;
    case b::Color::BLUE: octet raw[2][2];
    default: b::Later later;
  };
  struct Whole : b::Base {
    b::Table table;
    @default(value=3) ::a::b::Small small, other;
    sequence<string<10>> names;
    Which which[2];
    char letter; unsigned long long big; long long negative; byte plain;
    sequence<sequence<short>> rows;
  };
  module b {
    struct Later { short s; };
  };
};
)";
    Cdr cdr;
    cdr.put(std::uint32_t(9));
    for (std::uint32_t row = 0; row != 3; ++row) cdr.put(std::uint32_t(1)).put(std::int32_t(row));
    cdr.put(std::int8_t(1)).put(std::int8_t(0));
    cdr.put(std::uint32_t(2)).put("x").put("yz");
    cdr.put(std::int32_t(6));
    for (const std::uint8_t byte : {1, 2, 3, 4}) cdr.put(byte);
    cdr.put(std::int32_t(77)).put(std::int16_t(-3));
    cdr.put('A').put(~std::uint64_t(0)).put(std::int64_t(-5)).put(std::uint8_t(200));
    cdr.put(std::uint32_t(2)).put(std::uint32_t(0)).put(std::uint32_t(1)).put(std::int16_t(4));
    const std::string expected =
        "{id: 9, table: [[0], [1], [2]], small: 1, other: 0, names: ['x', 'yz'], which: [{raw: [[1, 2], [3, 4]]}, "
        "{later: {s: -3}}], letter: 65, big: 18446744073709551615, negative: -5, plain: 200, rows: [[], [4]]}";
    EXPECT_EQ(expected, walked("a::Whole", text, cdr));
    EXPECT_EQ(expected, walked("a/Whole", text, cdr));
}

TEST(McapSchema, IdlOfRos) {
    const char* const text =
        "================================================================================\n"
        "IDL: tank/msg/Level\n"
        "// generated from rosidl_adapter\n"
        "#include \"builtin_interfaces/msg/Time.idl\"\n"
        "module tank { module msg {\n"
        "  module Level_Constants { const octet FULL = 3; };\n"
        "  struct Level { builtin_interfaces::msg::Time stamp; @unit(value=\"m\") double height; };\n"
        "}; };\n"
        "================================================================================\n"
        "IDL: builtin_interfaces/msg/Time\n"
        "module builtin_interfaces { module msg { struct Time { int32 sec; uint32 nanosec; }; }; };\n";
    Cdr cdr;
    cdr.put(std::int32_t(1)).put(std::uint32_t(2)).put(0.25);
    EXPECT_EQ("{stamp: {sec: 1, nanosec: 2}, height: 0.25}", walked("tank/msg/Level", text, cdr, "ros2idl"));
}

TEST(McapSchema, TypesThatContainThemselvesEndWithTheirLists) {
    const char* const text = "struct T { long n; sequence<T> parts; };";
    Cdr cdr;
    cdr.put(std::int32_t(1)).put(std::uint32_t(1)).put(std::int32_t(2)).put(std::uint32_t(0));
    EXPECT_EQ("{n: 1, parts: [{n: 2, parts: []}]}", walked("T", text, cdr));
    Cdr deep;
    for (int i = 0; i != 200; ++i) deep.put(std::int32_t(i)).put(std::uint32_t(1));
    EXPECT_THAT(walked("T", text, deep), HasSubstr("structs nest too deeply"));
    EXPECT_EQ("a type contains itself", refusal("struct T { long n; T parts[2]; };"));
    EXPECT_EQ("a type contains itself", refusal("struct U { T t; }; struct T { U u; };"));
}

TEST(McapSchema, WrongIdlIsLocated) {
    const std::string deep(1000, '(');
    std::string modules, bases, sequences = "struct T { ";
    for (int i = 0; i != 200; ++i) modules += "module m {\n";
    for (int i = 0; i != 200; ++i) sequences += "sequence<";
    for (int i = 200; i-- > 1;)
        bases += "struct B" + std::to_string(i) + " : B" + std::to_string(i - 1) + " { long a; };\n";
    for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
             {"", "the text does not describe the type 'T'"},
             {"struct T {\n  lung a;\n};", "line 2: the type 'lung' is not described"},
             {"struct T {\n  long\n};", "line 3: found '}', expected a name"},
             {"struct T {\n  long a;", "line 2: the text ends, expected a type"},
             {"struct T { long a; }", "line 1: the text ends, expected ';'"},
             {"\nstruct T { };\nstruct T { };", "line 3: the type 'T' is described twice"},
             {"interface T { };", "line 1: found 'interface', expected 'module', 'struct', 'union', 'enum', 'const'"},
             {"struct T { long a[0]; };", "line 1: an array of 0 elements cannot be read"},
             {"struct T { long a[99999999999]; };", "an array of 99999999999 elements cannot be read"},
             {"struct T { long a[999999999999999999999]; };", "expected an integer"},
             {"struct T { long a[N]; };", "line 1: found 'N', expected an integer, or a constant"},
             {"struct T { long a[1/0]; };", "a number is divided by 0"},
             {"const long A = " + deep, "parentheses nest too deeply"},
             {"const long A = " + std::string(1000, '-'), "parentheses nest too deeply"},
             {modules, "line 101: modules nest too deeply"},
             {bases, "have no end"},
             {"struct T : U { long a; }; struct U : T { long a; };", "have no end"},
             {"struct T : U { long a; };", "the base 'U' is not a struct that is described"},
             {sequences, "types nest too deeply"},
             {"typedef A B; typedef B A; struct T { A a; };", "is another name of another name without end"},
             {"struct T { map<long, long> a; };", "fields of the type 'map' are not read"},
             {"struct T { long double a; };", "'long double' are not read"},
             {"struct T { @optional long a; };", "optional fields are not read"},
             {"struct E { }; struct T {\n E e; };", "line 2: the field 'e' has the type 'E' without fields"},
             {"union T switch (double) { case 1: long a; };", "the type behind 'switch' is not an integer or enum"},
             {"union T switch (long) { long a; };", "found 'long', expected 'case' or 'default'"},
             {"struct T { long a; }; /* ", "line 1: the comment has no end"},
             {"struct T { long a$; };", "line 1: found '$', which is not part of IDL"},
             {"@a(\"b) struct T { long a; };", "the text has no quotation mark at its end"}}) {
        EXPECT_THAT(refusal(text), HasSubstr(why)) << text.substr(0, 100);
    }
    EXPECT_THAT(refusal("syntax = \"proto3\";", "protobuf"),
                HasSubstr("described as 'protobuf', and only ros2msg, omgidl"));
}

TEST(McapSchema, MessagesThatAreDamaged) {
    const char* const text = "union T switch (short) { case -1: long a; };";
    Cdr cdr;
    cdr.put(std::int16_t(-1)).put(std::int32_t(5));
    EXPECT_EQ("{a: 5}", walked("T", text, cdr));
    Cdr other;
    other.put(std::int16_t(4));
    EXPECT_EQ("{}", walked("T", text, other));
    cdr.bytes.pop_back();
    EXPECT_EQ("byte 2: the message ends within a field", walked("T", text, cdr));
    cdr.bytes[1] = 3;  // a list of parameters
    EXPECT_EQ("byte 0: this is not plain CDR", walked("T", text, cdr));
}

}  // namespace
