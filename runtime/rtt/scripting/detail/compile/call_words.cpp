// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/call_words.hpp>

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

std::string joined(const std::vector<ast::Identifier>& parts) {
    std::string text;
    for (const auto& part : parts) text += (text.empty() ? "" : ".") + part.text;
    return text;
}

std::string counted(std::size_t count) {
    return count == 0 ? "no arguments" : count == 1 ? "1 argument" : std::to_string(count) + " arguments";
}

std::string signature(const std::string& name, const std::vector<base::DataSourceBase::shared_ptr>& arguments) {
    std::string text = name + "(";
    for (std::size_t i = 0; i != arguments.size(); ++i) text += (i ? ", " : "") + arguments[i]->getTypeName();
    return text + ")";
}

bool isChanged(const std::string& type) {
    static const std::string constant = " const&";
    const bool isConstant =
        type.size() >= constant.size() && type.compare(type.size() - constant.size(), std::string::npos, constant) == 0;
    return !type.empty() && type.back() == '&' && !isConstant;
}

std::string plainType(const std::string& type) {
    std::string plain = type.substr(0, type.find('&'));
    const std::size_t constant = plain.rfind(" const");
    if (constant != std::string::npos) plain.erase(constant);
    while (!plain.empty() && plain.back() == ' ') plain.pop_back();
    return plain;
}

std::string declarationOf(const OperationInterfacePart& part) {
    std::string text;
    for (const auto& argument : part.getArgumentList())
        text += (text.empty() ? "" : ", ") + plainType(argument.type) + (isChanged(argument.type) ? "&" : "") +
                (argument.name.empty() ? "" : " ") + argument.name;
    return plainType(part.resultType()) + ' ' + part.getName() + '(' + text + ')';
}

std::string elementsOf(const types::TypeInfo& type) {
    const auto members = type.getMemberNames();
    if (std::find(members.begin(), members.end(), "capacity") == members.end()) return "";
    const auto value = type.buildValue();
    const auto element = value ? value->getMember("0") : nullptr;
    if (!element) return "";
    const std::string name = element->getTypeName();
    return "its elements are of type " + name + (name == "double" ? ", as 1.0 is; 1 is an int" : "");
}

}  // namespace RTT::scripting::detail
