// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/detail/encoding.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace oroforge::xml::detail {

namespace {

constexpr std::size_t kNone = std::string::npos;

diag::Location placeOf(const std::string& text, std::size_t offset, const std::string& name) {
    const auto at = text.begin() + static_cast<std::ptrdiff_t>(offset);
    const auto line = std::count(text.begin(), at, '\n') + 1;
    const auto lineBegin = offset == 0 ? kNone : text.rfind('\n', offset - 1);
    return {name, static_cast<unsigned>(line),
            static_cast<unsigned>(offset - (lineBegin == kNone ? 0 : lineBegin + 1) + 1)};
}

std::string hexadecimal(char byte) {
    static constexpr char digits[] = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(byte);
    return std::string("0x") + digits[value >> 4U] + digits[value & 15U];
}

bool isControl(char c) {
    const auto u = static_cast<unsigned char>(c);
    return (u < 0x20U && c != '\t' && c != '\n' && c != '\r') || u == 0x7FU;
}

bool isPlainAscii(char c) {
    const auto u = static_cast<unsigned char>(c);
    return u < 0x80U && !isControl(c);
}

/// The encoding that the XML declaration names, and its place.
struct Declared {
    std::string name;
    std::size_t at = kNone;
};

Declared declaredEncoding(const std::string& text) {
    const std::size_t begin = text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
    if (text.compare(begin, 5, "<?xml") != 0) return {};
    const std::size_t end = text.find("?>", begin);
    const std::string_view declaration = std::string_view(text).substr(begin, end == kNone ? 0 : end - begin);
    const std::size_t word = declaration.find("encoding");
    const std::size_t quote = word == kNone ? kNone : declaration.find_first_of("\"'", word);
    const std::size_t close = quote == kNone ? kNone : declaration.find(declaration[quote], quote + 1);
    if (close == kNone) return {};
    return {std::string(declaration.substr(quote + 1, close - quote - 1)), begin + quote + 1};
}

std::string upper(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return name;
}

bool isUtf8(const std::string& name) { return upper(name) == "UTF-8" || upper(name) == "UTF8"; }

bool extendsAscii(const std::string& name) {
    const std::string all = upper(name);
    for (const char* begin : {"US-ASCII", "ASCII", "ISO-8859-", "ISO8859-", "LATIN", "WINDOWS-125", "CP125"})
        if (all.compare(0, std::string_view(begin).size(), begin) == 0) return true;
    return false;
}

void hintOfConversion(diag::Diagnostic& error, const std::string& encoding, const std::string& name) {
    error.hint("this makes it UTF-8: iconv -f " + encoding + " -t UTF-8 " + name +
               ", and encoding=\"UTF-8\" in its first line");
}

}  // namespace

std::size_t letterAt(const std::string& text, std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]);
    if (first < 0x80U) return 1;
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U || at + length > text.size()) return 0;
    for (std::size_t i = 1; i != length; ++i)
        if ((static_cast<unsigned char>(text[at + i]) & 0xC0U) != 0x80U) return 0;
    const auto second = static_cast<unsigned char>(text[at + 1]);
    const bool isOverlong = (first == 0xE0U && second < 0xA0U) || (first == 0xF0U && second < 0x90U);
    const bool isBeyond = (first == 0xEDU && second >= 0xA0U) || (first == 0xF4U && second >= 0x90U);
    return isOverlong || isBeyond ? 0 : length;
}

bool checkEncoding(const std::string& text, const std::string& name, diag::Sink& sink) {
    if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0) {
        hintOfConversion(sink.error({name, 1, 1}, "XML009", "the text is in UTF-16, expected UTF-8"), "UTF-16", name);
        return false;
    }
    const Declared declared = declaredEncoding(text);
    const bool isOther = declared.at != kNone && !isUtf8(declared.name);
    bool isAscii = true;
    for (std::size_t at = 0; at < text.size();) {
        if (isPlainAscii(text[at])) {
            ++at;
            continue;
        }
        if (text[at] == '\0') {
            sink.error(placeOf(text, at, name), "XML001", "found a zero byte; expected XML text in UTF-8");
            return false;
        }
        if (isControl(text[at])) {
            sink.error(placeOf(text, at, name), "XML009",
                       "found the control character " + hexadecimal(text[at]) + ", expected text");
            return false;
        }
        isAscii = false;
        if (isOther) break;
        const std::size_t length = letterAt(text, at);
        if (length == 0) {
            hintOfConversion(sink.error(placeOf(text, at, name), "XML009",
                                        "found the byte " + hexadecimal(text[at]) + ", expected text in UTF-8"),
                             "ISO-8859-1", name);
            return false;
        }
        at += length;
    }
    if (!isOther || (isAscii && extendsAscii(declared.name))) return true;
    const bool isName = !declared.name.empty() && declared.name.find_first_not_of(
                                                      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                                      "0123456789-_.:") == std::string::npos;
    diag::Diagnostic& error = sink.error(placeOf(text, declared.at, name), "XML009",
                                         "the encoding is '" + declared.name + "', expected UTF-8");
    if (isName) hintOfConversion(error, declared.name, name);
    return false;
}

}  // namespace oroforge::xml::detail
