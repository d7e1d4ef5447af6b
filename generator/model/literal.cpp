// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/literal.hpp>

#include <cctype>

namespace oroforge::model {

namespace {

bool isSign(const std::string& text, std::size_t at) {
    return at < text.size() && (text[at] == '-' || text[at] == '+');
}

std::size_t countDigits(const std::string& text, std::size_t& at) {
    const std::size_t begin = at;
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0) ++at;
    return at - begin;
}

}  // namespace

bool isBooleanText(const std::string& text) { return text == "true" || text == "false"; }

bool isIntegerText(const std::string& text) {
    std::size_t at = isSign(text, 0) ? 1 : 0;
    return countDigits(text, at) != 0 && at == text.size();
}

bool isNumberText(const std::string& text) {
    std::size_t at = isSign(text, 0) ? 1 : 0;
    std::size_t digits = countDigits(text, at);
    if (at < text.size() && text[at] == '.') digits += countDigits(text, ++at);
    if (digits == 0) return false;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        at += isSign(text, at + 1) ? 2 : 1;
        if (countDigits(text, at) == 0) return false;
    }
    return at == text.size();
}

}  // namespace oroforge::model
