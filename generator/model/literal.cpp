// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/literal.hpp>

#include <cctype>

#include <model/cpp_type.hpp>

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

std::string withSuffix(const std::string& number, TypeClass kind) {
    // A plus sign adds nothing, and C++ does not accept it in every place.
    std::string text = number.front() == '+' ? number.substr(1) : number;
    if (kind == TypeClass::Unsigned) return text + "U";
    if (kind == TypeClass::Signed) return text;
    if (text.find_first_of(".eE") == std::string::npos) text += ".0";
    return kind == TypeClass::Float ? text + "F" : text;
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

std::string stringLiteral(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        switch (c) {
            case '"': result += "\\\""; break;
            case '\\': result += "\\\\"; break;
            case '\n': result += "\\n"; break;
            case '\t': result += "\\t"; break;
            case '\r': break;
            default: result += c;
        }
    }
    return result + "\"";
}

std::string valueLiteral(const std::string& text, const std::string& type) {
    const TypeClass kind = classify(type);
    if (kind == TypeClass::String) return stringLiteral(text);
    if (kind == TypeClass::Character) {
        const std::string escaped = text == "'" ? "\\'" : text == "\\" ? "\\\\" : text;
        return "'" + escaped + "'";
    }
    return isNumber(kind) ? withSuffix(text, kind) : text;
}

}  // namespace oroforge::model
