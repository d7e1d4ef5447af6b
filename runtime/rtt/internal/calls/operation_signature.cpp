// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/operation_signature.hpp>

#include <rtt/internal/DataSourceTypeInfo.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT {

// A transport tells of its operations in words.
internal::OperationSignature OperationInterfacePart::signature() const {
    using Value = internal::OperationSignature::Value;
    internal::OperationSignature signature;
    const auto valueAt = [this](std::size_t index, const std::string& type) {
        Value value = Value::parsed(type);
        value.type = getArgumentType(static_cast<unsigned>(index));
        value.id = value.type ? value.type->getTypeId() : nullptr;
        return value;
    };
    signature.result = valueAt(0, resultType());
    for (const ArgumentDescription& argument : getArgumentList()) {
        Value value = valueAt(signature.arguments.size() + 1, argument.type);
        value.name = argument.name;
        value.description = argument.description;
        signature.arguments.push_back(std::move(value));
    }
    return signature;
}

namespace internal {

namespace {
/** True if the text ended with that, and blanks before it; both are removed. */
bool removeEnd(std::string& text, const std::string& end) {
    if (text.size() < end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0) return false;
    text.erase(text.size() - end.size());
    text.erase(text.find_last_not_of(' ') + 1);
    return true;
}
}  // namespace

std::string OperationSignature::Value::text() const {
    return typeName + detail::qualifierText(isConst, isReference, isPointer);
}

OperationSignature::Value OperationSignature::Value::parsed(const std::string& text) {
    Value value;
    value.typeName = text;
    value.isReference = removeEnd(value.typeName, "&");
    while (removeEnd(value.typeName, "&")) {
    }
    value.isPointer = removeEnd(value.typeName, "*");
    value.isConst = removeEnd(value.typeName, " const");
    if (value.typeName.compare(0, 6, "const ") == 0) {
        value.typeName.erase(0, 6);
        value.isConst = true;
    }
    return value;
}

std::vector<const OperationSignature::Value*> OperationSignature::collected() const {
    std::vector<const Value*> values;
    if (!result.isVoid()) values.push_back(&result);
    for (const Value& argument : arguments)
        if (argument.isOutput()) values.push_back(&argument);
    return values;
}

std::vector<ArgumentDescription> SignedPart::getArgumentList() const {
    std::vector<ArgumentDescription> list;
    for (const OperationSignature::Value& value : signature().arguments)
        list.emplace_back(value.name, value.description, value.text());
    return list;
}

std::string SignedPart::resultType() const { return signature().result.text(); }

unsigned SignedPart::arity() const { return static_cast<unsigned>(signature().arguments.size()); }

const types::TypeInfo* SignedPart::getArgumentType(unsigned index) const {
    const OperationSignature own = signature();
    if (index == 0) return own.result.type;
    return index <= own.arguments.size() ? own.arguments[index - 1].type : nullptr;
}

unsigned SignedPart::collectArity() const { return static_cast<unsigned>(signature().collected().size()); }

const types::TypeInfo* SignedPart::getCollectType(unsigned index) const {
    const OperationSignature own = signature();
    const auto values = own.collected();
    return index >= 1 && index <= values.size() ? values[index - 1]->type : nullptr;
}

}  // namespace internal
}  // namespace RTT
