// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/escape.hpp>

namespace oroforge::xml {

namespace {

std::string escape(const std::string& text, bool inAttribute) {
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '\r': result += "&#13;"; break;
            case '"': result += inAttribute ? "&quot;" : "\""; break;
            case '\n': result += inAttribute ? "&#10;" : "\n"; break;
            case '\t': result += inAttribute ? "&#9;" : "\t"; break;
            default:
                if (static_cast<unsigned char>(c) >= 0x20U) result += c;
        }
    }
    return result;
}

}  // namespace

std::string escapeText(const std::string& text) { return escape(text, false); }

std::string escapeAttribute(const std::string& text) { return escape(text, true); }

}  // namespace oroforge::xml
