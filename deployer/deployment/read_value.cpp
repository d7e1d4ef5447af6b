// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "read_value.hpp"

#include <cpf/cpf_reader.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>
#include <system_error>

namespace OCL::deploy {
namespace {

using TypeNames = std::initializer_list<const char*>;

constexpr TypeNames kBooleans = {"boolean", "bool"};
constexpr TypeNames kIntegers = {"short", "long", "ushort", "ulong", "int", "uint", "llong", "ullong"};
constexpr TypeNames kReals = {"double", "float", "short", "long", "ushort", "ulong", "int", "uint", "llong", "ullong"};
constexpr TypeNames kStrings = {"string"};

bool contains(TypeNames names, const std::string& name) {
    return std::any_of(names.begin(), names.end(), [&](const char* candidate) { return name == candidate; });
}

/** The text of the value if the element is a <simple> of one of these types, which messages call `expected`. */
std::optional<Text> valueOf(const xml::Element& element, TypeNames types, const std::string& expected,
                            diag::Sink& sink) {
    const std::string name = nameOf(element).value;
    if (element.name != "simple") {
        sink.error(element.where, "DEP004",
                   "found <" + element.name + "> '" + name + "', expected <simple> of type " + expected);
        return std::nullopt;
    }
    const xml::Attribute* type = element.requireAttribute("type", sink);
    if (!type) return std::nullopt;
    if (!contains(types, type->value)) {
        sink.error(type->valueWhere, "DEP004", "'" + name + "' is of type '" + type->value + "', expected " + expected);
        return std::nullopt;
    }
    const xml::Element* value = element.child("value");
    if (!value) {
        sink.error(element.where, "DEP003", "'" + name + "' has no <value>");
        return std::nullopt;
    }
    return Text{value->text, value->textWhere};
}

void badValue(const xml::Element& element, const Text& value, const std::string& expected, diag::Sink& sink) {
    sink.error(value.where, "DEP005",
               "the value of '" + nameOf(element).value + "' is '" + value.value + "', expected " + expected);
}

/** The digits of a number: its text without a plus sign and without the prefix of hexadecimal. */
struct Digits {
    const char* begin;
    const char* end;
    int base = 10;

    explicit Digits(const std::string& text, bool mayBeHexadecimal)
        : begin(text.data()), end(text.data() + text.size()) {
        if (end - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
        if (!mayBeHexadecimal || end - begin < 3 || *begin != '0' || (begin[1] != 'x' && begin[1] != 'X')) return;
        begin += 2;
        base = 16;
    }
};

/** Reports text after a number, which the original ignores; false if that is an error. */
bool isWhole(const xml::Element& element, const char* read, const Digits& digits, const Text& text,
             const std::string& expected, diag::Sink& sink) {
    return read == digits.end ||
           RTT::marsh::reportTextBehindNumber(text.where, "the value of '" + nameOf(element).value + "' is", text.value,
                                              std::string(text.value.data(), read), expected, sink);
}

/** The number of units in a second, for the unit from `at` to the end, perhaps after a space; 0 if it is unknown. */
double perSecond(const char* at, const char* end) {
    if (at != end && *at == ' ') ++at;
    const std::string name(at, end);
    return name == "s" ? 1 : name == "ms" ? 1e3 : name == "us" ? 1e6 : 0;
}

}  // namespace

Text nameOf(const xml::Element& element) {
    const xml::Attribute* name = element.attribute("name");
    return name ? Text{name->value, name->valueWhere} : Text{std::string(), element.where};
}

Text typeOf(const xml::Element& element) {
    const xml::Attribute* type = element.attribute("type");
    return type ? Text{type->value, type->valueWhere} : Text{std::string(), element.where};
}

bool requireStruct(const xml::Element& element, diag::Sink& sink) {
    if (element.name == "struct" || element.name == "sequence") return true;
    sink.error(element.where, "DEP004",
               "found <" + element.name + "> '" + nameOf(element).value + "', expected a <struct>");
    return false;
}

std::optional<bool> readBoolean(const xml::Element& element, diag::Sink& sink) {
    const std::optional<Text> text = valueOf(element, kBooleans, "boolean", sink);
    if (!text) return std::nullopt;
    if (text->value == "1" || text->value == "true") return true;
    if (text->value == "0" || text->value == "false") return false;
    badValue(element, *text, "0, 1, true or false", sink);
    return std::nullopt;
}

std::optional<long long> readInteger(const xml::Element& element, long long least, long long most, diag::Sink& sink,
                                     const std::string& meaning) {
    const std::optional<Text> text =
        valueOf(element, kIntegers, "short or long" + (meaning.empty() ? meaning : ": " + meaning), sink);
    if (!text) return std::nullopt;
    const Digits digits(text->value, true);
    long long number = 0;
    const auto read = std::from_chars(digits.begin, digits.end, number, digits.base);
    const std::string range = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    const std::string expected = meaning.empty() ? range : meaning;
    if (number < least || number > most || read.ec != std::errc()) {
        badValue(element, *text, expected, sink);
        return std::nullopt;
    }
    if (!isWhole(element, read.ptr, digits, *text, expected, sink)) return std::nullopt;
    return number;
}

std::optional<double> readTime(const xml::Element& element, TimeUnit unit, diag::Sink& sink) {
    const std::optional<Text> text = valueOf(element, kReals, "double", sink);
    if (!text) return std::nullopt;
    // Not read by the C library, which depends on the locale, and a component may have set that.
    const Digits digits(text->value, false);
    double number = 0;
    const auto read = std::from_chars(digits.begin, digits.end, number);
    const bool isSeconds = unit == TimeUnit::Seconds;
    const std::string expected =
        std::string("a number of ") + (isSeconds ? "seconds" : "milliseconds") + ", or one with the unit s, ms or us";
    if (!std::isfinite(number) || read.ec != std::errc()) {
        badValue(element, *text, expected, sink);
        return std::nullopt;
    }
    if (const double inSecond = perSecond(read.ptr, digits.end); inSecond != 0)
        return number * (isSeconds ? 1 : 1e3) / inSecond;
    if (!isWhole(element, read.ptr, digits, *text, expected, sink)) return std::nullopt;
    return number;
}

std::optional<Text> readString(const xml::Element& element, diag::Sink& sink) {
    return valueOf(element, kStrings, "string", sink);
}

std::optional<Text> readWord(const xml::Element& element, diag::Sink& sink) {
    const std::optional<Text> text = readString(element, sink);
    if (!text || !text->empty()) return text;
    const std::string name = nameOf(element).value;
    sink.error(element.where, "DEP003", (name.empty() ? "the element" : "'" + name + "'") + " has an empty <value>");
    return std::nullopt;
}

void checkTwice(const xml::Element& parent, const std::vector<std::string>& names, diag::Sink& sink) {
    std::map<std::string, diag::Location> seen;
    for (const xml::Element& child : parent.children) {
        const Text name = nameOf(child);
        if (child.name == "description" || child.name == "struct" || name.empty()) continue;
        if (!names.empty() && std::find(names.begin(), names.end(), name.value) == names.end()) continue;
        const auto [first, isNew] = seen.emplace(name.value, name.where);
        if (isNew) continue;
        sink.warning(name.where, "DEP060", "a second '" + name.value + "', which replaces the first")
            .note(first->second, "the first is here");
        first->second = name.where;
    }
}

}  // namespace OCL::deploy
