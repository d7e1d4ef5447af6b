// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/cpp_type.hpp>

#include <algorithm>
#include <cctype>
#include <set>

namespace oroforge::model {

namespace {

struct KnownType {
    const char* name;
    TypeClass kind;
    unsigned bits;
};

constexpr KnownType kKnownTypes[] = {
    {"bool", TypeClass::Boolean, 0},
    {"char", TypeClass::Character, 0},
    {"float", TypeClass::Float, 0},
    {"double", TypeClass::Double, 0},
    {"string", TypeClass::String, 0},
    {"std::string", TypeClass::String, 0},
    {"signed char", TypeClass::Signed, 8},
    {"unsigned char", TypeClass::Unsigned, 8},
    {"short", TypeClass::Signed, 16},
    {"unsigned short", TypeClass::Unsigned, 16},
    {"int", TypeClass::Signed, 32},
    {"unsigned int", TypeClass::Unsigned, 32},
    {"signed int", TypeClass::Signed, 32},
    {"unsigned", TypeClass::Unsigned, 32},
    {"uint", TypeClass::Unsigned, 32},
    {"long", TypeClass::Signed, 64},
    {"unsigned long", TypeClass::Unsigned, 64},
    {"long int", TypeClass::Signed, 64},
    {"unsigned long int", TypeClass::Unsigned, 64},
    {"long long", TypeClass::Signed, 64},
    {"unsigned long long", TypeClass::Unsigned, 64},
    {"int8_t", TypeClass::Signed, 8},
    {"uint8_t", TypeClass::Unsigned, 8},
    {"int16_t", TypeClass::Signed, 16},
    {"uint16_t", TypeClass::Unsigned, 16},
    {"int32_t", TypeClass::Signed, 32},
    {"uint32_t", TypeClass::Unsigned, 32},
    {"int64_t", TypeClass::Signed, 64},
    {"uint64_t", TypeClass::Unsigned, 64},
    {"size_t", TypeClass::Unsigned, 64},
};

const KnownType* lookUp(const std::string& type) {
    std::string name = normalised(type);
    if (name.compare(0, 2, "::") == 0) name.erase(0, 2);
    // The fixed-width names exist with and without std::.
    if (name.compare(0, 5, "std::") == 0 && name != "std::string") name.erase(0, 5);
    const auto found = std::find_if(std::begin(kKnownTypes), std::end(kKnownTypes),
                                    [&](const KnownType& known) { return name == known.name; });
    return found == std::end(kKnownTypes) ? nullptr : found;
}

bool isWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

}  // namespace

TypeClass classify(const std::string& type) {
    const KnownType* known = lookUp(type);
    return known == nullptr ? TypeClass::Other : known->kind;
}

unsigned integerBits(const std::string& type) {
    const KnownType* known = lookUp(type);
    return known == nullptr ? 0 : known->bits;
}

bool isInteger(TypeClass type) { return type == TypeClass::Signed || type == TypeClass::Unsigned; }

bool isNumber(TypeClass type) { return isInteger(type) || type == TypeClass::Float || type == TypeClass::Double; }

std::string normalised(const std::string& type) {
    std::string result;
    bool blank = false;
    for (const char c : type) {
        if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            blank = true;
            continue;
        }
        if (blank && !result.empty() && isWordLetter(result.back()) && isWordLetter(c)) result += ' ';
        blank = false;
        result += c;
    }
    return result;
}

bool isIdentifier(const std::string& name) {
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) return false;
    return std::all_of(name.begin(), name.end(), isWordLetter);
}

bool isKeyword(const std::string& name) {
    // C++20's keywords are included, so that a later standard compiles what is generated today.
    static const std::set<std::string> keywords = {
        "alignas",     "alignof",   "and",        "and_eq",    "asm",      "auto",         "bitand",
        "bitor",       "bool",      "break",      "case",      "catch",    "char",         "char8_t",
        "char16_t",    "char32_t",  "class",      "compl",     "concept",  "const",        "consteval",
        "constexpr",   "constinit", "const_cast", "continue",  "co_await", "co_return",    "co_yield",
        "decltype",    "default",   "delete",     "do",        "double",   "dynamic_cast", "else",
        "enum",        "explicit",  "export",     "extern",    "false",    "float",        "for",
        "friend",      "goto",      "if",         "inline",    "int",      "long",         "mutable",
        "namespace",   "new",       "noexcept",   "not",       "not_eq",   "nullptr",      "operator",
        "or",          "or_eq",     "private",    "protected", "public",   "register",     "reinterpret_cast",
        "requires",    "return",    "short",      "signed",    "sizeof",   "static",       "static_assert",
        "static_cast", "struct",    "switch",     "template",  "this",     "thread_local", "throw",
        "true",        "try",       "typedef",    "typeid",    "typename", "union",        "unsigned",
        "using",       "virtual",   "void",       "volatile",  "wchar_t",  "while",        "xor",
        "xor_eq"};
    return keywords.count(name) != 0;
}

std::vector<std::string> splitQualified(const std::string& name) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t at; (at = name.find("::", begin)) != std::string::npos; begin = at + 2) {
        parts.push_back(name.substr(begin, at - begin));
    }
    parts.push_back(name.substr(begin));
    return parts;
}

}  // namespace oroforge::model
