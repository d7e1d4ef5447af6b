// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/escape.hpp>

namespace oroforge::xml {

namespace {

/// Drops control characters other than blanks.
void appendEscaped(char c, bool inAttribute, std::string& to) {
    switch (c) {
        case '&': to += "&amp;"; break;
        case '<': to += "&lt;"; break;
        case '>': to += "&gt;"; break;
        case '\r': to += "&#13;"; break;
        case '"': to += inAttribute ? "&quot;" : "\""; break;
        case '\n': to += inAttribute ? "&#10;" : "\n"; break;
        case '\t': to += inAttribute ? "&#9;" : "\t"; break;
        default:
            if (static_cast<unsigned char>(c) >= 0x20U) to += c;
    }
}

std::string escape(const std::string& text, bool inAttribute) {
    std::string result;
    result.reserve(text.size());
    for (const char c : text) appendEscaped(c, inAttribute, result);
    return result;
}

}  // namespace

std::string escapeExactly(const std::string& text, bool inAttribute) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i != text.size(); ++i) {
        const char c = text[i];
        const bool plainSpace = c == ' ' && i != 0 && i + 1 != text.size() && text[i - 1] != ' ';
        const bool blankOrControl = static_cast<unsigned char>(c) <= 0x20U;
        if (blankOrControl && !plainSpace)
            result += "&#" + std::to_string(static_cast<int>(c)) + ';';
        else
            appendEscaped(c, inAttribute, result);
    }
    return result;
}

std::string escapeText(const std::string& text) { return escape(text, false); }

std::string escapeAttribute(const std::string& text) { return escape(text, true); }

}  // namespace oroforge::xml
