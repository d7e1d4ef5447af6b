// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <reporting/record.hpp>
#include <reporting/row_text.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <string>

namespace {

using namespace OCL::reporting;

std::string textOf(const Record& record, TextFormat format = TextFormat::Columns, int digits = 6) {
    std::vector<char> text;
    RecordReader reader(record.data(), record.size());
    while (reader.more()) {
        const Tag tag = reader.tag();
        appendValue(text, tag, reader, format, digits);
        text.push_back(' ');
    }
    return std::string(text.begin(), text.end());
}

std::string fieldOf(std::string_view value, TextFormat format) {
    std::vector<char> text;
    appendField(text, value, format);
    return std::string(text.begin(), text.end());
}

TEST(RowText, ValuesOfAllKinds) {
    Record record;
    record.value(Tag::Real, 0.5);
    record.value(Tag::Signed, std::int64_t(-3));
    record.value(Tag::Bool, true);
    record.value(Tag::Char, 'c');
    record.value(Tag::Unsigned, std::numeric_limits<std::uint64_t>::max());
    record.text(Tag::Text, "words");
    EXPECT_EQ("0.5 -3 1 c 18446744073709551615 words ", textOf(record));
    EXPECT_EQ("0.5 -3 1 c 18446744073709551615 words ", textOf(record, TextFormat::Csv));
}

TEST(RowText, InColumnsATextHasNothingThatEndsItsField) {
    const auto field = [](std::string_view value) { return fieldOf(value, TextFormat::Columns); };
    EXPECT_EQ("\"\"", field(""));
    EXPECT_EQ("two\\x20words", field("two words"));
    EXPECT_EQ("\\none\\ttwo\\x0d\\n", field("\none\ttwo\r\n"));
    EXPECT_EQ("\\x22a\\x22\\x23", field("\"a\"#"));
    EXPECT_EQ("c:\\\\x20", field("c:\\x20"));
    EXPECT_EQ("\\x00\\x7f", field(std::string_view("\0\x7f", 2)));
    EXPECT_EQ("a,b'\xc3\xa4", field("a,b'\xc3\xa4"));
}

TEST(RowText, InCsvATextIsQuotedIfItMustBe) {
    const auto field = [](std::string_view value) { return fieldOf(value, TextFormat::Csv); };
    EXPECT_EQ("\"\"", field(""));
    EXPECT_EQ("two words", field("two words"));
    EXPECT_EQ("\"a,b\"", field("a,b"));
    EXPECT_EQ("\"say \"\"so\"\"\"", field("say \"so\""));
    EXPECT_EQ("\"two\nlines\"", field("two\nlines"));
    EXPECT_EQ("\"\r\"", field("\r"));
    EXPECT_EQ("\" blank\"", field(" blank"));
}

TEST(RowText, CsvHasAllDigits) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 20000; ++i) {
        const std::uint64_t bits = random();
        double value;
        std::memcpy(&value, &bits, sizeof value);
        if (std::isnan(value)) continue;
        Record record;
        record.value(Tag::Real, value);
        ASSERT_EQ(value, std::strtod(textOf(record, TextFormat::Csv).c_str(), nullptr));
    }
    Record record;
    for (const double value : {0.1, 1.0 / 3, 1e300, HUGE_VAL, -HUGE_VAL, std::nan(""), -std::nan("")})
        record.value(Tag::Real, value);
    record.value(Tag::Float, 0.1f);
    EXPECT_EQ("0.1 0.3333333333333333 1e+300 inf -inf nan nan 0.1 ", textOf(record, TextFormat::Csv));
}

template <class T>
void expectAsStream(T value, Tag tag, int digits) {
    std::ostringstream expected;
    expected.precision(digits);
    expected << value << " ";
    Record record;
    record.value(tag, value);
    ASSERT_EQ(expected.str(), textOf(record, TextFormat::Columns, digits));
}

TEST(RowText, NumbersHaveTheDigitsOfAStream) {
    for (double value : {0.0, -0.0, 1.0, 0.1, 1e5, 999999.5, 1e6, 1234567.0, 1e-4, 1e-5, 1.0 / 3, 1e300, -1e-300,
                         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()})
        for (int digits : {1, 6, 17}) expectAsStream(value, Tag::Real, digits);
    std::mt19937_64 random(7);
    for (int i = 0; i < 100000; ++i) {
        double value;
        const std::uint64_t bits = random();
        std::memcpy(&value, &bits, sizeof value);
        expectAsStream(value, Tag::Real, 6);
        expectAsStream(std::ldexp(static_cast<double>(bits), -60), Tag::Real, 6);
    }
    for (float value : {0.1f, 1e10f, 16777216.0f, std::numeric_limits<float>::max()})
        expectAsStream(value, Tag::Float, 6);
}

TEST(Record, GrowsWithWhatIsPutIn) {
    Record record;
    std::string expected;
    for (int i = 0; i < 10000; ++i) {
        record.value(Tag::Signed, std::int64_t(i));
        expected += std::to_string(i) + ' ';
    }
    EXPECT_EQ(expected, textOf(record));
    record.clear();
    EXPECT_EQ(0u, record.size());
}

}  // namespace
