// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_text.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/rt_string.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/calls/sent_call.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <sstream>
#include <vector>

namespace OCL::console {
namespace {

using RTT::base::DataSourceBase;
typedef DataSourceBase::shared_ptr Source;

constexpr int kMostElements = 10;
constexpr int kDeepest = 8;
// Few enough digits that 0.1 + 0.2 is shown as 0.3.
constexpr int kDigits = 12, kDigitsOfFloat = 6;

std::string textOf(const Source& value, bool hex, int depth);

std::string asNumber(unsigned char c) {
    constexpr const char* kDigits = "0123456789abcdef";
    return std::string("\\x") + kDigits[c / 16] + kDigits[c % 16];
}

std::string quoted(const std::string& text, char quote) {
    std::string result(1, quote);
    for (const char c : text) {
        if (c == quote || c == '\\') result += '\\';
        if (c == '\n')
            result += "\\n";
        else if (c == '\t')
            result += "\\t";
        else if (c == '\0')
            result += "\\0";
        else if (static_cast<unsigned char>(c) < ' ' || c == '\177')
            result += asNumber(static_cast<unsigned char>(c));  // it would move the cursor or change colours
        else
            result += c;
    }
    return result + quote;
}

std::string bagText(const RTT::PropertyBag& bag, bool hex, int depth) {
    std::string text;
    for (const auto* property : bag)
        text += (text.empty() ? "" : ", ") + property->getName() + " = " +
                textOf(property->getDataSource(), hex, depth + 1);
    return "{" + text + "}";
}

bool isSequence(const std::vector<std::string>& members) {
    return !members.empty() && std::all_of(members.begin(), members.end(), [](const std::string& name) {
        return name == "size" || name == "capacity";
    });
}

int elementsOf(const Source& value) {
    const Source size = value->getMember("size");
    const auto* const number = size ? RTT::internal::DataSource<int>::narrow(size.get()) : nullptr;
    return number ? number->get() : 0;
}

Source elementOf(const Source& value, int index) {
    return value->getMember(Source(new RTT::internal::ConstantDataSource<int>(index)));
}

std::string sequenceText(const Source& value, bool hex, int depth) {
    const int size = elementsOf(value);
    std::string text;
    for (int i = 0; i != std::min(size, kMostElements); ++i) {
        const Source element = elementOf(value, i);
        text += (i ? ", " : "") + (element ? textOf(element, hex, depth + 1) : std::string("?"));
    }
    if (size > kMostElements) text += ", … " + std::to_string(size - kMostElements) + " more";
    return "[" + text + "]";
}

std::string membersText(const Source& value, const std::vector<std::string>& names, bool hex, int depth) {
    std::string text;
    for (const std::string& name : names) {
        const Source member = value->getMember(name);
        if (member) text += (text.empty() ? "" : ", ") + name + " = " + textOf(member, hex, depth + 1);
    }
    return "{" + text + "}";
}

bool isUnknown(const Source& value) { return value->getTypeInfo() == RTT::types::Types()->unknownType(); }

std::string textOf(const Source& value, bool hex, int depth) {
    if (!value) return "(null)";
    if (depth > kDeepest) return "…";
    // A value of an unknown type cannot be copied, so this may be a call, which must not be made again.
    if (RTT::internal::DataSource<RTT::internal::SentCall::shared_ptr>::narrow(value.get())) return "SendHandle";
    if (isUnknown(value)) return "(unknown_t)";
    value->evaluate();
    if (const auto* const text = RTT::internal::DataSource<std::string>::narrow(value.get()))
        return quoted(text->rvalue(), '"');
    if (const auto* const text = RTT::internal::DataSource<RTT::rt_string>::narrow(value.get()))
        return quoted(std::string(text->rvalue().begin(), text->rvalue().end()), '"');
    if (const auto* const letter = RTT::internal::DataSource<char>::narrow(value.get()))
        return quoted(std::string(1, letter->rvalue()), '\'');
    if (const auto* const truth = RTT::internal::DataSource<bool>::narrow(value.get()))
        return truth->rvalue() ? "true" : "false";
    if (const auto* const bag = RTT::internal::DataSource<RTT::PropertyBag>::narrow(value.get()))
        return bagText(bag->rvalue(), hex, depth);
    const std::vector<std::string> members = value->getMemberNames();
    if (isSequence(members)) return sequenceText(value, hex, depth);
    if (!members.empty()) return membersText(value, members, hex, depth);
    std::ostringstream text;
    text.precision(RTT::internal::DataSource<float>::narrow(value.get()) ? kDigitsOfFloat : kDigits);
    if (hex) text << std::hex << std::showbase;
    value->write(text);
    return text.str();
}

}  // namespace

std::vector<std::pair<std::string, Source>> partsOf(const Source& value, std::size_t& left) {
    std::vector<std::pair<std::string, Source>> parts;
    left = 0;
    if (!value || isUnknown(value)) return parts;
    value->evaluate();
    if (const auto* const bag = RTT::internal::DataSource<RTT::PropertyBag>::narrow(value.get())) {
        for (const auto* property : bag->rvalue()) parts.emplace_back(property->getName(), property->getDataSource());
        return parts;
    }
    // Texts have members, too.
    if (RTT::internal::DataSource<std::string>::narrow(value.get()) ||
        RTT::internal::DataSource<RTT::rt_string>::narrow(value.get()))
        return parts;
    const std::vector<std::string> names = value->getMemberNames();
    if (isSequence(names)) {
        const int size = elementsOf(value), shown = std::min(size, kMostElements);
        for (int i = 0; i < shown; ++i) parts.emplace_back("[" + std::to_string(i) + "]", elementOf(value, i));
        left = static_cast<std::size_t>(std::max(size - shown, 0));
        return parts;
    }
    for (const std::string& name : names)
        if (const Source member = value->getMember(name)) parts.emplace_back(name, member);
    return parts;
}

std::string valueText(const RTT::base::DataSourceBase::shared_ptr& value, bool hex) { return textOf(value, hex, 0); }

}  // namespace OCL::console
