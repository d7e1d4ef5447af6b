// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cpf_values.hpp"

#include <rtt/types/Types.hpp>

#include <algorithm>
#include <charconv>
#include <type_traits>

namespace RTT::marsh {

namespace {

struct Text {
    const std::string& name;
    const std::string& description;
    const std::string& value;
};

template <class T>
void make(SimpleValue& result, const Text& text, const T& value) {
    result.property = new Property<T>(text.name, text.description, value);
}

void readBool(SimpleValue& result, const Text& text) {
    result.expected = "'true', 'false', '1' or '0'";
    if (text.value == "true" || text.value == "1") make(result, text, true);
    if (text.value == "false" || text.value == "0") make(result, text, false);
}

template <class C>
void readChar(SimpleValue& result, const Text& text) {
    result.expected = "one character";
    const std::string& letter = text.value;
    if (letter.size() <= 1) make<C>(result, text, letter.empty() ? C() : static_cast<C>(letter[0]));
    // A char beyond ASCII is written as the letter with that code in Latin-1.
    const bool isLatin = letter.size() == 2 && (letter[0] == '\xC2' || letter[0] == '\xC3');
    if (isLatin)
        make<C>(result, text, static_cast<C>((letter[0] == '\xC3' ? 0x40 : 0) | static_cast<unsigned char>(letter[1])));
}

void readString(SimpleValue& result, const Text& text) { make(result, text, text.value); }

/** Reads a number; one too small for T becomes the nearest that T has. */
template <class T>
bool roundsToNothing(const char* begin, const char* end, T& value) {
    long double wide = 0;
    if (std::from_chars(begin, end, wide).ec != std::errc() || wide > 1 || wide < -1) return false;
    value = static_cast<T>(wide);
    return true;
}

/** Reads what the C library reads, hexadecimal included. `begin` is after a leading '+'. */
template <class T>
std::from_chars_result parseReal(const char* begin, const char* end, T& value) {
    const bool negative = begin != end && *begin == '-';
    const char* digits = begin + negative;
    if (end - digits > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
        const auto read = std::from_chars(digits + 2, end, value, std::chars_format::hex);
        if (negative) value = -value;
        return read;
    }
    auto read = std::from_chars(begin, end, value);
    if (read.ec == std::errc::result_out_of_range && roundsToNothing(begin, end, value)) read.ec = std::errc();
    return read;
}

/** Does not depend on the locale. */
template <class T>
void readNumber(SimpleValue& result, const Text& text) {
    constexpr bool isReal = std::is_floating_point<T>::value;
    result.expected = isReal ? "a number" : "a whole number";
    const char* begin = text.value.data();
    const char* end = begin + text.value.size();
    if (end - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
    T value{};
    std::from_chars_result read{};
    if constexpr (isReal)
        read = parseReal(begin, end, value);
    else
        read = std::from_chars(begin, end, value);
    result.outOfRange = read.ec == std::errc::result_out_of_range;
    if (read.ec != std::errc()) return;
    result.trailingText = read.ptr != end;
    make(result, text, value);
}

struct SimpleType {
    const char* name;
    void (*read)(SimpleValue& result, const Text& text);
};

/** The names of the format, then those of scripts, which many projects use in their files. */
constexpr SimpleType simpleTypes[] = {
    {"boolean", &readBool},
    {"char", &readChar<char>},
    {"octet", &readChar<unsigned char>},
    {"uchar", &readChar<unsigned char>},
    {"long", &readNumber<int>},
    {"short", &readNumber<int>},
    {"ulong", &readNumber<unsigned int>},
    {"ushort", &readNumber<unsigned int>},
    {"llong", &readNumber<long long>},
    {"ullong", &readNumber<unsigned long long>},
    {"double", &readNumber<double>},
    {"float", &readNumber<float>},
    {"string", &readString},
    {"bool", &readBool},
    {"int", &readNumber<int>},
    {"uint", &readNumber<unsigned int>},
};

/** The shortest text that reads back as the same number. */
template <class T>
std::string numberText(T value) {
    char buffer[64];
    const auto written = std::to_chars(buffer, buffer + sizeof buffer, value);
    return std::string(buffer, written.ptr);
}

struct Written {
    std::string& type;
    std::string& text;
};

bool set(const Written& to, const char* type, std::string text) {
    to.type = type;
    to.text = std::move(text);
    return true;
}

template <class T>
const T* valueIn(const base::PropertyBase& property) {
    const auto* typed = dynamic_cast<const Property<T>*>(&property);
    return typed ? &typed->rvalue() : nullptr;
}

template <class T>
bool writeNumber(const base::PropertyBase& property, const char* type, const Written& to) {
    const T* value = valueIn<T>(property);
    return value && set(to, type, numberText(*value));
}

template <class C>
bool writeChar(const base::PropertyBase& property, const char* type, const Written& to) {
    const C* value = valueIn<C>(property);
    return value && set(to, type, *value ? std::string(1, static_cast<char>(*value)) : std::string());
}

}  // namespace

SimpleValue readSimple(const std::string& type, const std::string& name, const std::string& description,
                       const std::string& text) {
    SimpleValue result;
    for (const auto& known : simpleTypes) {
        if (type != known.name) continue;
        known.read(result, Text{name, description, text});
        return result;
    }
    result.knownType = false;
    return result;
}

bool isSequenceType(const std::string& name) {
    const types::TypeInfo* type = name.empty() || name == "string" ? nullptr : types::Types()->type(name);
    const auto members = type ? type->getMemberNames() : std::vector<std::string>();
    return std::find(members.begin(), members.end(), "capacity") != members.end();
}

bool writeSimple(const base::PropertyBase& property, std::string& type, std::string& text) {
    const Written to{type, text};
    if (const bool* value = valueIn<bool>(property)) return set(to, "boolean", *value ? "1" : "0");
    if (const std::string* value = valueIn<std::string>(property)) return set(to, "string", *value);
    return writeNumber<double>(property, "double", to) || writeNumber<int>(property, "long", to) ||
           writeNumber<float>(property, "float", to) || writeNumber<unsigned int>(property, "ulong", to) ||
           writeNumber<long long>(property, "llong", to) || writeNumber<unsigned long long>(property, "ullong", to) ||
           writeNumber<short>(property, "short", to) || writeNumber<unsigned short>(property, "ushort", to) ||
           writeChar<char>(property, "char", to) || writeChar<unsigned char>(property, "octet", to);
}

}  // namespace RTT::marsh
