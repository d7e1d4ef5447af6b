// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/call_words.hpp>

#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

std::string joined(const std::vector<ast::Identifier>& parts, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i != parts.size() && i != most; ++i) text += (i ? "." : "") + parts[i].text;
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

std::string plainType(const std::string& type) { return internal::OperationSignature::Value::parsed(type).plainText(); }

std::string declarationOf(const OperationInterfacePart& part) {
    const internal::OperationSignature signature = part.signature();
    std::string text;
    for (const auto& argument : signature.arguments)
        text += (text.empty() ? "" : ", ") + argument.plainText() + (argument.isOutput() ? "&" : "") +
                (argument.name.empty() ? "" : " ") + argument.name;
    return signature.result.plainText() + ' ' + part.getName() + '(' + text + ')';
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
