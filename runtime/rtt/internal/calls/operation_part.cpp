// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/operation_part.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/Handle.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/calls/detail/action_slot.hpp>
#include <rtt/internal/calls/detail/call_handles.hpp>
#include <rtt/internal/calls/operation_table.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::internal {

namespace {

typedef OperationSignature::Value Value;

Value valueOf(const ValueType& type) {
    const types::TypeInfo* const info = type.info();
    return {info, type.id, info->getTypeName(), type.isConst, type.isReference, type.isPointer, "", ""};
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
    OperationSignature signature = types();
    for (std::size_t i = 1; i <= table_->arity; ++i) {
        Value& value = signature.arguments[i - 1];
        const bool documented = 2 * i < texts.size();
        value.name = documented ? texts[2 * i - 1] : "arg" + std::to_string(i);
        if (documented) value.description = texts[2 * i];
    }
    return signature;
}

OperationSignature OperationPart::types() const {
    OperationSignature signature;
    signature.result = valueOf(table_->types[0]);
    signature.arguments.reserve(table_->arity);
    for (std::size_t i = 1; i <= table_->arity; ++i) signature.arguments.push_back(valueOf(table_->types[i]));
    return signature;
}

OperationPart::Args OperationPart::accepted(const Args& args) const {
    const auto fits = [](const ValueType& wanted, const Source& found) {
        const std::type_info* const id = found ? found->getTypeId() : nullptr;
        return id && *id == *wanted.id && (!wanted.isOutput() || found->isAssignable());
    };
    bool exact = args.size() == table_->arity;
    for (std::size_t i = 0; exact && i != args.size(); ++i) exact = fits(table_->types[i + 1], args[i]);
    return exact ? args : checkedArguments(args);
}

void OperationPart::checkSendable() const {
    if (call_only_)
        throw no_asynchronous_operation_exception("operation '" + getName() + "' can be called, but not sent");
}

OperationPart::Source OperationPart::produce(const Args& args, ExecutionEngine* caller) const {
    return table_->makeSource(GenericCall(Caller(caller_->cloneFor(caller)), *table_, accepted(args), description_));
}

OperationPart::Source OperationPart::produceSend(const Args& args, ExecutionEngine* caller) const {
    checkSendable();
    Caller sender(caller_->cloneFor(caller));
    sender->setGeneric();
    return new detail::SendSource(GenericCall(std::move(sender), *table_, accepted(args), description_));
}

OperationPart::Source OperationPart::produceHandle() const {
    checkSendable();
    return new ValueDataSource<SentCall::shared_ptr>();
}

OperationPart::Source OperationPart::produceCollect(const Args& args, DataSource<bool>::shared_ptr blocking) const {
    checkSendable();
    auto* const handle = DataSource<SentCall::shared_ptr>::narrow(args.empty() ? nullptr : args[0].get());
    checkCollected(args, handle != nullptr);
    return new detail::CollectSource(*table_, handle, Args(args.begin() + 1, args.end()), std::move(blocking));
}

Handle OperationPart::produceSignal(base::ActionInterface* action, const Args& args,
                                    ExecutionEngine* subscriber) const {
    CalleeBase* const callee = caller_->callee();
    if (!callee || !callee->signal()) return OperationInterfacePart::produceSignal(action, args, subscriber);
    checkCount(table_->arity, args.size());
    for (std::size_t i = 0; i != args.size(); ++i) {
        const Value value = valueOf(table_->types[i + 1]);
        value.checkAssigned(args[i], i + 1);
        // Arguments for another thread are copied to values of their type.
        if (subscriber && !value.type->buildValue()) value.throwWrongType(args[i], i + 1);
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
