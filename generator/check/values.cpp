// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <model/cpp_type.hpp>
#include <model/interfaces.hpp>
#include <model/literal.hpp>

namespace oroforge::check {

namespace {

using model::TypeClass;

bool fitsInteger(const std::string& text, TypeClass kind, unsigned bits) {
    errno = 0;
    if (kind == TypeClass::Unsigned) {
        if (text.front() == '-') return std::strtoll(text.c_str(), nullptr, 10) == 0 && errno == 0;
        const unsigned long long value = std::strtoull(text.c_str(), nullptr, 10);
        return errno == 0 && (bits == 64 || value < (1ULL << bits));
    }
    const long long value = std::strtoll(text.c_str(), nullptr, 10);
    if (errno != 0) return false;
    if (bits == 64) return true;
    const long long limit = 1LL << (bits - 1);
    return value >= -limit && value < limit;
}

/// Returns why `text` cannot be a value of `type`; empty if it can.
std::string valueFault(const std::string& text, const std::string& type) {
    const TypeClass kind = model::classify(type);
    switch (kind) {
        case TypeClass::Boolean: return model::isBooleanText(text) ? "" : "is not 'true' or 'false'";
        case TypeClass::Signed:
        case TypeClass::Unsigned:
            if (!model::isIntegerText(text)) return "is not a whole number";
            return fitsInteger(text, kind, model::integerBits(type)) ? "" : "does not fit the type '" + type + "'";
        case TypeClass::Float:
        case TypeClass::Double: {
            if (!model::isNumberText(text)) return "is not a number";
            const double value = std::strtod(text.c_str(), nullptr);
            const double largest = kind == TypeClass::Float ? 3.4028234663852886e38 : 1.7976931348623157e308;
            return std::fabs(value) <= largest ? "" : "does not fit the type '" + type + "'";
        }
        case TypeClass::Character: return text.size() == 1 ? "" : "is not one character";
        case TypeClass::String: return {};
        case TypeClass::Other: return text.empty() ? "is empty; expected a C++ value" : "";
    }
    return {};
}

void checkDefault(const model::Text& value, const model::Text& type, diag::Sink& sink) {
    if (!value.given() || !type.given()) return;
    const std::string fault = valueFault(value.value, type.value);
    if (!fault.empty()) sink.error(value.where, "OM030", "default '" + value.value + "' " + fault);
}

bool checkLimit(const char* what, const std::optional<model::Number>& limit, const model::Text& type,
                diag::Sink& sink) {
    if (!limit) return false;
    if (!model::isNumber(model::classify(type.value))) {
        sink.error(limit->where, "OM032",
                   "'" + std::string(what) + "' needs a number type, found '" + type.value + "'");
        return false;
    }
    const std::string fault = valueFault(limit->text, type.value);
    if (!fault.empty()) sink.error(limit->where, "OM031", std::string(what) + " '" + limit->text + "' " + fault);
    return fault.empty();
}

/// `what` says whether it is a property or an attribute.
void checkRange(const std::string& what, const model::Value& property, diag::Sink& sink) {
    const bool hasMinimum = checkLimit("min", property.minimum, property.type, sink);
    const bool hasMaximum = checkLimit("max", property.maximum, property.type, sink);
    if (hasMinimum && hasMaximum && property.minimum->value > property.maximum->value) {
        sink.error(property.minimum->where, "OM033",
                   "min '" + property.minimum->text + "' is greater than max '" + property.maximum->text + "'")
            .note(property.maximum->where, "the maximum is here");
        return;
    }
    if (!hasMinimum && !hasMaximum) return;
    if (property.defaultValue.given() && !valueFault(property.defaultValue.value, property.type.value).empty()) return;
    // Without a default the property starts as zero, which must be in the range as well.
    const bool given = property.defaultValue.given();
    const std::string shown =
        given ? "default '" + property.defaultValue.value + "'" : "the " + what + " has no default, and 0";
    const double value = given ? std::strtod(property.defaultValue.value.c_str(), nullptr) : 0.0;
    const diag::Location& where = given ? property.defaultValue.where : property.where;
    if (hasMinimum && value < property.minimum->value) {
        sink.error(where, "OM034", shown + " is less than min '" + property.minimum->text + "'")
            .note(property.minimum->where, "the minimum is here");
    } else if (hasMaximum && value > property.maximum->value) {
        sink.error(where, "OM034", shown + " is greater than max '" + property.maximum->text + "'")
            .note(property.maximum->where, "the maximum is here");
    }
}

void checkValue(const std::string& what, const model::Value& value, diag::Sink& sink) {
    checkDefault(value.defaultValue, value.type, sink);
    if (value.type.given()) checkRange(what, value, sink);
}

}  // namespace

void values(const model::Package& package, diag::Sink& sink) {
    model::eachInterface(package, [&](const model::Interface& interface, const model::ServicePath&) {
        for (const auto& property : interface.properties) checkValue("property", property, sink);
        for (const auto& attribute : interface.attributes) {
            checkValue("attribute", attribute, sink);
            if (!attribute.constant || attribute.defaultValue.given()) continue;
            sink.error(attribute.where, "OM035",
                       "the constant '" + attribute.name.value + "' has no value; expected the attribute 'default'");
        }
    });
}

}  // namespace oroforge::check
