// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "encoded_types.hpp"

#include <cmath>
#include <limits>

using encoded::EncodedTypes;
using sample::Tank;

namespace {

template <class T>
void comesBack(const RTT::encoding::Json& json, const T& value, const std::string& text) {
    EXPECT_EQ(json.text(&value), text);
    T back{};
    EXPECT_EQ(json.parse(text, &back), "");
    EXPECT_EQ(json.text(&back), text);
}

}  // namespace

TEST_F(EncodedTypes, JsonShowsNamesAndNestedValues) {
    Tank tank;
    tank.label = "a \"tank\"\n";
    tank.path = {{1, 2}};
    tank.mode = sample::Mode::Filling;
    tank.flags = {true};
    comesBack(*jsonOf<Tank>(), tank,
              R"({"id":0,"label":"a \"tank\"\n","position":{"x":0,"y":0},"levels":[],"path":[{"x":1,"y":2}],)"
              R"("weights":[0,0,0],"pair":[0,0],"mode":"Filling","small":0,"flags":[true]})");
}

TEST_F(EncodedTypes, JsonKeepsAllDigits) {
    comesBack(*jsonOf<double>(), 0.1, "0.1");
    comesBack(*jsonOf<double>(), std::nextafter(0.1, 1), "0.10000000000000002");
    comesBack(*jsonOf<double>(), std::numeric_limits<double>::denorm_min(), "5e-324");
    comesBack(*jsonOf<double>(), -0.0, "-0.0");
    comesBack(*jsonOf<float>(), 0.1F, "0.1");
    comesBack(*jsonOf<float>(), std::numeric_limits<float>::max(), "3.4028235e+38");
    comesBack(*jsonOf<float>(), std::numeric_limits<float>::lowest(), "-3.4028235e+38");
    comesBack(*jsonOf<double>(), std::numeric_limits<double>::quiet_NaN(), "\"NaN\"");
    comesBack(*jsonOf<double>(), -std::numeric_limits<double>::infinity(), "\"-Infinity\"");
    comesBack(*jsonOf<unsigned long long>(), ~0ULL, "18446744073709551615");
    comesBack(*jsonOf<long long>(), std::numeric_limits<long long>::min(), "-9223372036854775808");
}

TEST_F(EncodedTypes, JsonKeepsBytesThatAreNoText) {
    comesBack(*jsonOf<std::string>(), std::string("a\xff"), "[97,255]");
    comesBack(*jsonOf<std::string>(), std::string("gr\xc3\xbc\xc3\x9f"), "\"gr\xc3\xbc\xc3\x9f\"");
    comesBack(*jsonOf<char>(), 'A', "\"A\"");
    comesBack(*jsonOf<char>(), '\x80', "-128");
}

TEST_F(EncodedTypes, JsonOfAnEnumeratorWithoutANameIsItsNumber) {
    comesBack(*jsonOf<sample::Mode>(), static_cast<sample::Mode>(99), "99");
}

TEST_F(EncodedTypes, MistakesInJsonHaveAPlace) {
    const auto json = jsonOf<Tank>();
    Tank tank;
    const auto mistake = [&](const std::string& text) { return json->parse(text, &tank); };
    EXPECT_EQ(mistake("{"), "byte 2: the text is no JSON");
    EXPECT_EQ(mistake("[]"), "found array, expected an object");
    EXPECT_EQ(mistake(R"({"idd": 1})"), "there is no field 'idd'");
    EXPECT_EQ(mistake(R"({"path": [{"x": 1}, {"x": "far"}]})"), "path[1].x: found \"far\", expected a number");
    EXPECT_EQ(mistake(R"({"small": 256})"), "small: found 256, expected a number from 0 to 255");
    EXPECT_EQ(mistake(R"({"small": -1})"), "small: found -1, expected a number from 0 to 255");
    EXPECT_EQ(mistake(R"({"id": 1.5})"), "id: found 1.5, expected a whole number");
    EXPECT_EQ(mistake(R"({"weights": [1, 2]})"), "weights: found array, expected an array of 3 elements");
    EXPECT_EQ(mistake(R"({"mode": "Idel"})"),
              "mode: found \"Idel\", expected one of: Idle, Filling, Draining, Emptying");
    EXPECT_EQ(mistake(R"({"flags": [1]})"), "flags[0]: found 1, expected true or false");
    EXPECT_EQ(mistake(R"({"mode": 258})"), "mode: found 258, expected a number that the enumeration can have");
    float number = 0;
    EXPECT_EQ(jsonOf<float>()->parse("1e300", &number), "found 1e+300, expected a number that is not so large");
    EXPECT_EQ(jsonOf<float>()->parse("3.4028236e38", &number),
              "found 3.4028236e+38, expected a number that is not so large");
    unsigned zero = 1;
    EXPECT_EQ(jsonOf<unsigned>()->parse("-0", &zero), "");
    EXPECT_EQ(mistake(R"({"levels": [1e999]})"), "the text has a number that is too large");
}

TEST_F(EncodedTypes, FieldsThatJsonLacksKeepTheirValues) {
    Tank tank;
    tank.id = 4;
    EXPECT_EQ(jsonOf<Tank>()->parse(R"({"small": 2})", &tank), "");
    EXPECT_TRUE(tank.id == 4 && tank.small == 2);
}

TEST_F(EncodedTypes, JsonHasASchemaThatFoxgloveReads) {
    const auto schemaOf = [](const auto& json) { return json->schema(); };
    EXPECT_EQ(schemaOf(jsonOf<bool>()), R"({"type":"boolean"})");
    EXPECT_EQ(schemaOf(jsonOf<sample::Mode>()), R"({"enum":["Idle","Filling","Draining","Emptying"],"type":"string"})");
    const std::string tank = schemaOf(jsonOf<Tank>());
    EXPECT_THAT(tank, testing::HasSubstr(R"("label":{"type":"string"})"));
    EXPECT_THAT(tank, testing::HasSubstr(R"("levels":{"items":{"type":"number"},"type":"array"})"));
    EXPECT_THAT(tank, testing::HasSubstr(R"("weights":{"items":{"type":"number"},"type":"array"})"));
    EXPECT_THAT(tank, testing::HasSubstr(R"("path":{"items":{"properties":{"x":)"));
    // What Foxglove does not read, and would refuse the whole service for.
    EXPECT_EQ(schemaOf(jsonOf<encoded::Matrix>()), "");
    EXPECT_EQ(schemaOf(jsonOf<encoded::Tree>()), R"({"properties":{"value":{"type":"integer"}},"type":"object"})");
}
