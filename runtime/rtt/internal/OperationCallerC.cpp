// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/OperationCallerC.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActionInterface.hpp>

#include <exception>

namespace RTT::internal {

OperationCallerC::OperationCallerC(const OperationInterfacePart* part, const std::string& name, ExecutionEngine* caller)
    : part_(OperationInterfacePart::hold(part)), name_(name), caller_(caller) {}
OperationCallerC::~OperationCallerC() = default;

OperationCallerC& OperationCallerC::arg(Source argument) {
    arguments_.push_back(argument);
    call_ = nullptr;
    return *this;
}

OperationCallerC& OperationCallerC::ret(Source variable) {
    result_ = variable;
    call_ = nullptr;
    return *this;
}

OperationCallerC& OperationCallerC::ret(base::AttributeBase* attribute) {
    return ret(attribute ? attribute->getDataSource() : Source());
}

void OperationCallerC::check() const {
    if (!part_) throw name_not_found_exception(name_);
    part_->produce(arguments_, caller_);
}

bool OperationCallerC::prepare() {
    if (call_) return true;
    store_result_.reset();
    try {
        if (!part_) throw name_not_found_exception(name_);
        Source call = part_->produce(arguments_, caller_);
        if (result_) store_result_.reset(result_->updateAction(call.get()));
        call_ = call;
        return true;
    } catch (const bad_assignment&) {
        log(Error) << "operation '" << name_ << "' cannot be called: its result is of type " << part_->resultType()
                   << ", the variable for it of type " << result_->getType() << endlog();
    } catch (const std::exception& e) {
        log(Error) << "operation '" << name_ << "' cannot be called: " << e.what() << endlog();
    }
    return false;
}

bool OperationCallerC::call() {
    if (!prepare()) return false;
    if (!store_result_) return call_->evaluate();
    store_result_->readArguments();
    return store_result_->execute();
}

SendHandleC OperationCallerC::send() {
    const Source sending = getSendDataSource();
    if (!sending) return SendHandleC();
    const Source handle = part_->produceHandle();
    if (!handle->update(sending.get())) return SendHandleC();
    return SendHandleC(handle, part_.get(), name_);
}

bool OperationCallerC::ready() const {
    if (call_) return true;
    try {
        check();
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

OperationCallerC::Source OperationCallerC::getCallDataSource() { return prepare() ? call_ : Source(); }

OperationCallerC::Source OperationCallerC::getSendDataSource() {
    try {
        if (!part_) throw name_not_found_exception(name_);
        return part_->produceSend(arguments_, caller_);
    } catch (const std::exception& e) {
        log(Error) << "operation '" << name_ << "' cannot be sent: " << e.what() << endlog();
        return nullptr;
    }
}

}  // namespace RTT::internal
