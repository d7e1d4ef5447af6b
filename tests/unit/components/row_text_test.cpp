// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <reporting/record.hpp>
#include <reporting/row_text.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>

namespace {

using namespace OCL::reporting;

std::string textOf(const Record& record, int digits = 6) {
    std::vector<char> text;
    appendRow(text, record.data(), record.size(), digits);
    return std::string(text.begin(), text.end());
}

TEST(RowText, BlankBeforeEachValueOneMoreForABagAndOneAtTheEnd) {
    Record record;
    record.value(Tag::Real, 0.5);
    record.tag(Tag::Bag);
    record.value(Tag::Signed, std::int64_t(-3));
    record.value(Tag::Bool, true);
    record.value(Tag::Char, 'c');
    record.value(Tag::Unsigned, std::numeric_limits<std::uint64_t>::max());
    record.text(Tag::Text, "two words");
    EXPECT_EQ(" 0.5  -3 1 c 18446744073709551615 two words \n", textOf(record));
}

TEST(RowText, AnEmptyRowIsABlank) { EXPECT_EQ(" \n", textOf(Record())); }

TEST(RowText, ALineIsWrittenAsItIs) {
    Record record;
    record.text(Tag::Line, " TimeStamp a.b");
    EXPECT_EQ(" TimeStamp a.b\n", textOf(record));
}

TEST(RowText, AnEmptyTextIsAValueToo) {
    Record record;
    record.text(Tag::Text, "");
    record.value(Tag::Bool, true);
    EXPECT_EQ(" \"\" 1 \n", textOf(record));
}

TEST(RowText, LineEndsInsideTextsAreEscaped) {
    Record record;
    record.text(Tag::Text, "\none\ntwo\n");
    record.value(Tag::Char, '\n');
    EXPECT_EQ(" \\none\\ntwo\\n \\n \n", textOf(record));
}

template <class T>
void expectAsStream(T value, Tag tag, int digits) {
    std::ostringstream expected;
    expected.precision(digits);
    expected << ' ' << value << " \n";
    Record record;
    record.value(tag, value);
    ASSERT_EQ(expected.str(), textOf(record, digits));
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
        expected += ' ' + std::to_string(i);
    }
    EXPECT_EQ(expected + " \n", textOf(record));
    record.clear();
    EXPECT_EQ(0u, record.size());
}

}  // namespace
