// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/rtt_rosservice_proxy.h>

#include <boost/core/demangle.hpp>

namespace rtt_roscomm {

namespace {

std::string textOf(const RTT::internal::CallerValue& value) {
    const RTT::types::TypeInfo* const known = RTT::types::Types()->getTypeById(value.type);
    return (known ? known->getTypeName() : boost::core::demangle(value.type->name())) +
           (value.isOutput ? " &" : value.isConstant ? " const&" : "");
}

}  // namespace

bool fits(const RTT::OperationInterfacePart& operation, const RTT::internal::CallerSignature& signature) {
    const RTT::internal::OperationSignature found = operation.signature();
    if (found.arguments.size() != signature.arity) return false;
    const auto isSame = [](const RTT::internal::OperationSignature::Value& value, const std::type_info& type) {
        return type == typeid(void) ? value.isVoid() : value.id && !value.isPointer && *value.id == type;
    };
    if (!isSame(found.result, *signature.values[0].type)) return false;
    for (unsigned i = 1; i <= signature.arity; ++i) {
        const auto& argument = found.arguments[i - 1];
        if (!isSame(argument, *signature.values[i].type)) return false;
        if (argument.isOutput() && !signature.values[i].isOutput) return false;
    }
    return true;
}

std::string textOf(const RTT::internal::CallerSignature& signature) {
    std::string text = textOf(signature.values[0]) + "(";
    for (unsigned i = 1; i <= signature.arity; ++i) text += (i > 1 ? ", " : "") + textOf(signature.values[i]);
    return text + ")";
}

}  // namespace rtt_roscomm
