// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/operation_signature.hpp>

#include <rtt/FactoryExceptions.hpp>
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

void OperationSignature::Value::throwWrongType(const base::DataSourceBase::shared_ptr& found, std::size_t index) const {
    throw wrong_types_of_args_exception(static_cast<int>(index), text(), found ? found->getType() : "nothing");
}

bool OperationSignature::Value::isTypeOf(const base::DataSourceBase& source) const {
    const std::type_info* const found = source.getTypeId();
    return id ? found && *found == *id : type && source.getTypeInfo() == type;
}

void OperationSignature::Value::checkAssigned(const base::DataSourceBase::shared_ptr& to, std::size_t index) const {
    if (!to || !isTypeOf(*to)) throwWrongType(to, index);
    if (!to->isAssignable()) throw non_lvalue_args_exception(static_cast<int>(index), to->getType());
}

base::DataSourceBase::shared_ptr OperationSignature::Value::sourceFor(base::DataSourceBase::shared_ptr source,
                                                                      std::size_t index) const {
    if (!source) throwWrongType(source, index);
    if (isOutput() && !source->isAssignable())
        throw non_lvalue_args_exception(static_cast<int>(index), source->getType());
    if (type && !isTypeOf(*source) && !isOutput()) source = type->convert(source);
    if (!source || !isTypeOf(*source)) throwWrongType(source, index);
    return source;
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

std::string SignedPart::resultType() const { return types().result.text(); }

unsigned SignedPart::arity() const { return static_cast<unsigned>(types().arguments.size()); }

const types::TypeInfo* SignedPart::getArgumentType(unsigned index) const {
    const OperationSignature own = types();
    if (index == 0) return own.result.type;
    return index <= own.arguments.size() ? own.arguments[index - 1].type : nullptr;
}

unsigned SignedPart::collectArity() const { return static_cast<unsigned>(types().collected().size()); }

const types::TypeInfo* SignedPart::getCollectType(unsigned index) const {
    const OperationSignature own = types();
    const auto values = own.collected();
    return index >= 1 && index <= values.size() ? values[index - 1]->type : nullptr;
}

void SignedPart::checkCount(std::size_t wanted, std::size_t received) {
    if (wanted != received) throw wrong_number_of_args_exception(static_cast<int>(wanted), static_cast<int>(received));
}

SignedPart::Args SignedPart::checkedArguments(const Args& args) const {
    const OperationSignature own = types();
    checkCount(own.arguments.size(), args.size());
    Args checked;
    for (std::size_t i = 0; i != args.size(); ++i) checked.push_back(own.arguments[i].sourceFor(args[i], i + 1));
    return checked;
}

void SignedPart::checkCollected(const Args& args, bool isHandle) const {
    const OperationSignature own = types();
    const auto values = own.collected();
    if (args.size() != 1) checkCount(1 + values.size(), args.size());
    if (!isHandle) throw wrong_types_of_args_exception(1, "SendHandle", args[0] ? args[0]->getType() : "nothing");
    for (std::size_t i = 1; i != args.size(); ++i) values[i - 1]->checkAssigned(args[i], i + 1);
}

}  // namespace internal
}  // namespace RTT
