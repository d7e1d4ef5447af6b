// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_TOOL_JSON_LINE_HPP
#define OROFORGE_MCAP_TOOL_JSON_LINE_HPP

#include <reporting/schema/part_taker.hpp>

#include <cstdio>
#include <string>
#include <string_view>

namespace oroforge::mcap {

/** A message as JSON on one line. Bytes of texts are written as they are, and nan and inf as texts. */
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
        for (const char c : text) {
            if (c == '"' || c == '\\') {
                line += '\\';
                line += c;
            } else if (static_cast<unsigned char>(c) < ' ') {
                char code[8];
                (void)std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
                line += code;
            } else {
                line += c;
            }
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
