// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/cpp_words.hpp>

#include <algorithm>
#include <cctype>

namespace oroforge::typekit {

std::string cppString(const std::string& text) {
    static const char* const kDigits = "01234567";
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n') {
            result += "\\n";
        } else if (c == '"' || c == '\\') {
            result += std::string("\\") + c;
        } else if (byte < 0x20 || byte == 0x7f) {
            // Three octal digits end the escape, whatever character follows.
            result += std::string("\\") + kDigits[byte >> 6] + kDigits[(byte >> 3) & 7] + kDigits[byte & 7];
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string cppLines(const std::string& text) {
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        result += (result.empty() ? "" : "\n") + std::string("      ") + cppString(text.substr(begin, end - begin));
        begin = end;
    }
    return result.empty() ? "      \"\"" : result;
}

std::string cppLetters(const std::string& text) {
    std::string result;
    for (const char c : text) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return result;
}

std::string cppIdentifier(const std::string& text) {
    std::string result = cppLetters(text);
    if (!result.empty() && std::isdigit(static_cast<unsigned char>(result[0])) != 0) result.insert(0, "_");
    return result;
}

}  // namespace oroforge::typekit
