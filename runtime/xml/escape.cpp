// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/escape.hpp>

#include <xml/detail/encoding.hpp>

namespace oroforge::xml {

namespace {

/// Appends a char, escaped where necessary; drops control characters other than blanks.
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
            if (static_cast<unsigned char>(c) >= 0x20U && c != '\x7f') to += c;
    }
}

std::string reference(char c) { return "&#" + std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + ';'; }

bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80U; }

/// Copies a letter beyond ASCII and returns how many bytes it has. A byte that is not UTF-8 is read as Latin-1.
std::size_t appendLetter(const std::string& text, std::size_t at, std::string& to) {
    const std::size_t length = detail::letterAt(text, at);
    if (length == 0) to += reference(text[at]);
    to.append(text, at, length);
    return length == 0 ? 1 : length;
}

std::string escape(const std::string& text, bool inAttribute) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        if (isAscii(text[i]))
            appendEscaped(text[i++], inAttribute, result);
        else
            i += appendLetter(text, i, result);
    }
    return result;
}

}  // namespace

std::string escapeExactly(const std::string& text, bool inAttribute) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (!isAscii(c)) {
            i += appendLetter(text, i, result);
            continue;
        }
        const bool plainSpace = c == ' ' && i != 0 && i + 1 != text.size() && text[i - 1] != ' ';
        const bool blankOrControl = static_cast<unsigned char>(c) <= 0x20U || c == '\x7f';
        if (blankOrControl && !plainSpace)
            result += reference(c);
        else
            appendEscaped(c, inAttribute, result);
        ++i;
    }
    return result;
}

std::string asUtf8(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = detail::letterAt(text, i);
        if (length == 0) {
            const auto byte = static_cast<unsigned char>(text[i]);
            result += {static_cast<char>(0xC0U | byte >> 6U), static_cast<char>(0x80U | (byte & 0x3FU))};
        }
        result.append(text, i, length);
        i += length == 0 ? 1 : length;
    }
    return result;
}

std::string escapeText(const std::string& text) { return escape(text, false); }

std::string escapeAttribute(const std::string& text) { return escape(text, true); }

}  // namespace oroforge::xml
