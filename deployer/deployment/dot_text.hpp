// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writes names and labels for Graphviz.
#ifndef OROFORGE_DEPLOYMENT_DOT_TEXT_HPP
#define OROFORGE_DEPLOYMENT_DOT_TEXT_HPP

#include <string>

namespace OCL::deploy {

inline std::string dotEscaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

inline std::string dotQuoted(const std::string& text) { return '"' + dotEscaped(text) + '"'; }

inline std::string dotTwoLines(const std::string& first, const std::string& second) {
    return '"' + dotEscaped(first) + "\\n" + dotEscaped(second) + '"';
}

}  // namespace OCL::deploy

#endif
