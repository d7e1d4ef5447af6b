// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_TOOL_JSON_LINE_HPP
#define OROFORGE_MCAP_TOOL_JSON_LINE_HPP

#include <reporting/schema/part_taker.hpp>

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace oroforge::mcap {

/** The bytes of the letter that begins there; 0 if that is not UTF-8. */
inline std::size_t letterAt(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
    };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4) return 0;
    const std::size_t size = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    for (std::size_t i = 1; i != size; ++i)
        if ((byte(i) & 0xc0U) != 0x80) return 0;
    // Overlong forms, halves of UTF-16 and what is beyond Unicode.
    const bool isWrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                         (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    return isWrong ? 0 : size;
}

/** A message as JSON on one line. Bytes that are not UTF-8 become U+FFFD, and nan and inf texts. */
class JsonLine : public schema::PartTaker {
public:
    std::string line;

    void beginStruct() override {
        line += '{';
        isFirst_ = true;
    }
    void field(std::string_view name) override {
        separate();
        text(name);
        line += ": ";
    }
    void endStruct() override {
        line += '}';
        isFirst_ = false;
    }
    void beginList() override {
        line += '[';
        isFirst_ = true;
    }
    void element(std::size_t) override { separate(); }
    void endList() override {
        line += ']';
        isFirst_ = false;
    }
    void number(std::string_view number) override {
        const bool isFinite = number.find("nan") == number.npos && number.find("inf") == number.npos;
        if (isFinite)
            line += number;
        else
            text(number);
    }
    void text(std::string_view text) override {
        line += '"';
        for (std::size_t at = 0; at != text.size();) {
            const char c = text[at];
            const std::size_t size = letterAt(text, at);
            if (size == 0) {
                line += "\xef\xbf\xbd";
            } else if (c == '"' || c == '\\') {
                line += '\\';
                line += c;
            } else if (static_cast<unsigned char>(c) < ' ') {
                char code[8];
                (void)std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
                line += code;
            } else {
                line += text.substr(at, size);
            }
            at += size == 0 ? 1 : size;
        }
        line += '"';
    }

private:
    void separate() {
        if (!isFirst_) line += ", ";
        isFirst_ = false;
    }

    bool isFirst_ = true;  // of what is open
};

}  // namespace oroforge::mcap

#endif
