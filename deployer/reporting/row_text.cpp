// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "row_text.hpp"

#include "other_value.hpp"
#include "record.hpp"

#include <charconv>
#include <string>
#include <string_view>

namespace OCL::reporting {
namespace {

typedef std::vector<char> Text;

void append(Text& text, std::string_view more) { text.insert(text.end(), more.begin(), more.end()); }

void appendOneLine(Text& text, std::string_view value) {
    for (std::size_t end; (end = value.find('\n')) != value.npos; value.remove_prefix(end + 1)) {
        append(text, value.substr(0, end));
        append(text, "\\n");
    }
    append(text, value);
}

/** Writes "" in quotes for an empty text, because otherwise later values would move to other columns. */
void appendText(Text& text, std::string_view value) {
    if (value.empty())
        append(text, "\"\"");
    else
        appendOneLine(text, value);
}

/** Enough for any number: its digits, a sign, a point and an exponent. */
constexpr std::size_t kNumberRoom = 320;

template <class T, class... Format>
void appendNumber(Text& text, T value, Format... format) {
    char digits[kNumberRoom];
    const std::to_chars_result result = std::to_chars(digits, digits + kNumberRoom, value, format...);
    text.insert(text.end(), digits, result.ptr);
}

void appendReal(Text& text, double value, int digits) { appendNumber(text, value, std::chars_format::general, digits); }

}  // namespace

void appendValue(Text& text, Tag tag, RecordReader& record, int digits) {
    switch (tag) {
        case Tag::Bag:
        case Tag::End: return;
        case Tag::Bool: return text.push_back(record.value<bool>() ? '1' : '0');
        case Tag::Char: return appendOneLine(text, std::string_view(record.bytes(1), 1));
        case Tag::Signed: return appendNumber(text, record.value<std::int64_t>());
        case Tag::Unsigned: return appendNumber(text, record.value<std::uint64_t>());
        case Tag::Float: return appendReal(text, static_cast<double>(record.value<float>()), digits);
        case Tag::Real: return appendReal(text, record.value<double>(), digits);
        case Tag::Text: return appendText(text, record.text());
        case Tag::Other: {
            const OtherValue* const other = record.value<const OtherValue*>();
            return appendText(text, other->text(record.bytes(other->size())));
        }
        case Tag::Line:
        case Tag::Name: return append(text, record.text());
    }
}

void appendRow(Text& text, const char* record, std::size_t size, int digits) {
    RecordReader reader(record, size);
    bool row = true;
    while (reader.more()) {
        const Tag tag = reader.tag();
        row = tag != Tag::Line;
        if (row) text.push_back(' ');
        appendValue(text, tag, reader, digits);
    }
    if (row) text.push_back(' ');
    text.push_back('\n');
}

}  // namespace OCL::reporting
