// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "row_text.hpp"

#include "other_value.hpp"

#include <charconv>
#include <cmath>
#include <string>

namespace OCL::reporting {
namespace {

typedef std::vector<char> Text;

void append(Text& text, std::string_view more) { text.insert(text.end(), more.begin(), more.end()); }

void appendEscaped(Text& text, char letter) {
    constexpr char kDigits[] = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(letter);
    switch (letter) {
        case '\n': return append(text, "\\n");
        case '\t': return append(text, "\\t");
        case '\\': return append(text, "\\\\");
        default: break;
    }
    if (code > 0x20 && letter != '\x7f' && letter != '"' && letter != '#') return text.push_back(letter);
    append(text, "\\x");
    text.push_back(kDigits[code >> 4U]);
    text.push_back(kDigits[code & 15U]);
}

void appendQuoted(Text& text, std::string_view value) {
    const bool plain =
        !value.empty() && value.front() != ' ' && value.back() != ' ' && value.find_first_of("\",\r\n") == value.npos;
    if (plain) return append(text, value);
    text.push_back('"');
    for (const char letter : value) {
        if (letter == '"') text.push_back('"');
        text.push_back(letter);
    }
    text.push_back('"');
}

/** Enough for any number: its digits, a sign, a point and an exponent. */
constexpr std::size_t kNumberRoom = 320;

template <class T, class... Format>
void appendNumber(Text& text, T value, Format... format) {
    char digits[kNumberRoom];
    const std::to_chars_result result = std::to_chars(digits, digits + kNumberRoom, value, format...);
    text.insert(text.end(), digits, result.ptr);
}

template <class T>
void appendReal(Text& text, T value, TextFormat format, int digits) {
    if (format == TextFormat::Columns)
        appendNumber(text, static_cast<double>(value), std::chars_format::general, digits);
    else if (std::isnan(value))
        append(text, "nan");  // its sign means nothing, and not every reader knows "-nan"
    else
        appendNumber(text, value);
}

}  // namespace

void appendField(Text& text, std::string_view value, TextFormat format) {
    if (format == TextFormat::Csv) return appendQuoted(text, value);
    if (value.empty()) return append(text, "\"\"");
    for (const char letter : value) appendEscaped(text, letter);
}

void appendValue(Text& text, Tag tag, RecordReader& record, TextFormat format, int digits) {
    switch (tag) {
        case Tag::Bool: return text.push_back(record.value<bool>() ? '1' : '0');
        case Tag::Char: return appendField(text, std::string_view(record.bytes(1), 1), format);
        case Tag::Signed: return appendNumber(text, record.value<std::int64_t>());
        case Tag::Unsigned: return appendNumber(text, record.value<std::uint64_t>());
        case Tag::Float: return appendReal(text, record.value<float>(), format, digits);
        case Tag::Real: return appendReal(text, record.value<double>(), format, digits);
        case Tag::Text: return appendField(text, record.text(), format);
        case Tag::Other: {
            const OtherValue* const other = record.value<const OtherValue*>();
            return appendField(text, other->text(record.bytes(other->size())), format);
        }
        case Tag::Bag:
        case Tag::Sequence:
        case Tag::Absent:
        case Tag::Fields: return;  // no values
    }
}

}  // namespace OCL::reporting
