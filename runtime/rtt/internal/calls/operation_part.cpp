// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/operation_part.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/Handle.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/calls/operation_table.hpp>
#include <rtt/internal/calls/detail/action_slot.hpp>
#include <rtt/internal/calls/detail/call_handles.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::internal {

namespace {

typedef OperationSignature::Value Value;

Value valueOf(const ValueType& type) {
    const types::TypeInfo* const info = type.info();
    return {info, type.id, info->getTypeName(), type.isConst, type.isReference, type.isPointer, "", ""};
}

bool holds(const base::DataSourceBase& source, const Value& wanted) {
    const std::type_info* const id = source.getTypeId();
    return id && *id == *wanted.id;
}

[[noreturn]] void throwWrongType(std::size_t index, const Value& wanted,
                                 const base::DataSourceBase::shared_ptr& source) {
    throw wrong_types_of_args_exception(static_cast<int>(index), wanted.text(), source ? source->getType() : "nothing");
}

/** Throws unless `to`, which is argument `index`, can be assigned values of that type. */
void checkAssigned(const base::DataSourceBase::shared_ptr& to, const Value& wanted, std::size_t index) {
    if (!to || !holds(*to, wanted)) throwWrongType(index, wanted, to);
    if (!to->isAssignable()) throw non_lvalue_args_exception(static_cast<int>(index), to->getType());
}

void checkCount(std::size_t wanted, std::size_t received) {
    if (wanted != received) throw wrong_number_of_args_exception(static_cast<int>(wanted), static_cast<int>(received));
}

/** The source of argument `index`, counted from 1: `source` itself, or one that converts its value. */
base::DataSourceBase::shared_ptr sourceFor(const Value& wanted, base::DataSourceBase::shared_ptr source,
                                           std::size_t index) {
    if (!source) throwWrongType(index, wanted, source);
    if (wanted.isOutput() && !source->isAssignable())
        throw non_lvalue_args_exception(static_cast<int>(index), source->getType());
    if (!holds(*source, wanted) && !wanted.isOutput()) source = wanted.type->convert(source);
    if (!source || !holds(*source, wanted)) throwWrongType(index, wanted, source);
    return source;
}

}  // namespace

OperationPart::OperationPart(std::shared_ptr<const base::OperationDescription> description, Caller caller,
                             const OperationTable& table, bool callOnly)
    : description_(std::move(description)), caller_(std::move(caller)), table_(&table), call_only_(callOnly) {}

void OperationPart::overload(const std::type_info& signature, Caller other) {
    other->setThread(caller_->getThread(), caller_->getOwner());
    overloads_.push_back({&signature, std::move(other)});
}

const OperationPart::Caller& OperationPart::callerOf(const std::type_info& signature) const {
    for (const Overload& other : overloads_)
        if (*other.signature == signature) return other.caller;
    return caller_;
}

void OperationPart::setThread(ExecutionThread et, ExecutionEngine* owner) const {
    caller_->setThread(et, owner);
    for (const Overload& other : overloads_) other.caller->setThread(et, owner);
}

std::string OperationPart::getName() const { return description_->name; }
std::string OperationPart::description() const { return description_->texts.front(); }

OperationSignature OperationPart::signature() const {
    const std::vector<std::string>& texts = description_->texts;
    OperationSignature signature;
    signature.result = valueOf(table_->types[0]);
    for (std::size_t i = 1; i <= table_->arity; ++i) {
        Value value = valueOf(table_->types[i]);
        const bool documented = 2 * i < texts.size();
        value.name = documented ? texts[2 * i - 1] : "arg" + std::to_string(i);
        if (documented) value.description = texts[2 * i];
        signature.arguments.push_back(std::move(value));
    }
    return signature;
}

OperationPart::Args OperationPart::checkedArguments(const Args& args) const {
    checkCount(table_->arity, args.size());
    Args checked;
    for (std::size_t i = 1; i <= args.size(); ++i)
        checked.push_back(sourceFor(valueOf(table_->types[i]), args[i - 1], i));
    return checked;
}

void OperationPart::checkSendable() const {
    if (call_only_)
        throw no_asynchronous_operation_exception("operation '" + getName() + "' can be called, but not sent");
}

OperationPart::Source OperationPart::produce(const Args& args, ExecutionEngine* caller) const {
    return table_->makeSource(
        GenericCall(Caller(caller_->cloneFor(caller)), *table_, checkedArguments(args), description_));
}

OperationPart::Source OperationPart::produceSend(const Args& args, ExecutionEngine* caller) const {
    checkSendable();
    Caller sender(caller_->cloneFor(caller));
    sender->setGeneric();
    return new detail::SendSource(GenericCall(std::move(sender), *table_, checkedArguments(args), description_));
}

OperationPart::Source OperationPart::produceHandle() const {
    checkSendable();
    return new ValueDataSource<SentCall::shared_ptr>();
}

OperationPart::Source OperationPart::produceCollect(const Args& args, DataSource<bool>::shared_ptr blocking) const {
    checkSendable();
    const OperationSignature own = signature();
    const auto values = own.collected();
    if (args.size() != 1) checkCount(1 + values.size(), args.size());
    auto* const handle = DataSource<SentCall::shared_ptr>::narrow(args[0].get());
    if (!handle) throw wrong_types_of_args_exception(1, "SendHandle", args[0] ? args[0]->getType() : "nothing");
    for (std::size_t i = 1; i != args.size(); ++i) checkAssigned(args[i], *values[i - 1], i + 1);
    return new detail::CollectSource(*table_, handle, Args(args.begin() + 1, args.end()), std::move(blocking));
}

Handle OperationPart::produceSignal(base::ActionInterface* action, const Args& args,
                                    ExecutionEngine* subscriber) const {
    CalleeBase* const callee = caller_->callee();
    if (!callee || !callee->signal()) return OperationInterfacePart::produceSignal(action, args, subscriber);
    checkCount(table_->arity, args.size());
    for (std::size_t i = 0; i != args.size(); ++i) {
        const Value value = valueOf(table_->types[i + 1]);
        checkAssigned(args[i], value, i + 1);
        // Arguments for another thread are copied to values of their type.
        if (subscriber && !value.type->buildValue()) throwWrongType(i + 1, value, args[i]);
    }
    const auto slot = std::make_shared<detail::ActionSlot>(action, args, subscriber);
    callee->signal()->add(slot, true);
    return Handle(slot);
}

OperationPart* OperationPart::reimplemented(const base::OperationBase& by) const {
    if (*by.table().sentType != *table_->sentType) return nullptr;
    const Caller& implementation = by.implementation();
    if (CalleeBase* const function = implementation->callee()) {
        function->listenLike(caller_->callee());
        function->belongsTo(description_);
    }
    return new OperationPart(description_, implementation, by.table(), call_only_);
}

}  // namespace RTT::internal
