// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/OperationBase.hpp>

#include <rtt/internal/calls/operation_part.hpp>

namespace RTT::base {

OperationBase::OperationBase(const std::string& name, OperationCallerInterface* implementation,
                             const internal::OperationTable& table)
    : description_(std::make_shared<OperationDescription>()), implementation_(implementation), table_(&table) {
    description_->name = name;
    description_->texts.resize(1);
}

OperationBase::~OperationBase() = default;

OperationBase::OperationBase(const OperationBase& other)
    : description_(std::make_shared<OperationDescription>(*other.description_)),
      implementation_(other.implementation_->cloneFor(nullptr)),
      table_(other.table_) {}

OperationBase& OperationBase::operator=(const OperationBase& other) {
    if (this == &other) return *this;
    description_ = std::make_shared<OperationDescription>(*other.description_);
    implementation_.reset(other.implementation_->cloneFor(nullptr));
    table_ = other.table_;
    return *this;
}

void OperationBase::setOwner(ExecutionEngine* owner) {
    implementation_->setThread(implementation_->getThread(), owner);
}
void OperationBase::setThread(ExecutionThread et) { implementation_->setThread(et, implementation_->getOwner()); }

void OperationBase::setFunction(internal::CalleeBase* function, ExecutionThread et, ExecutionEngine* owner) {
    if (function) {
        function->listenLike(implementation_->callee());
        function->belongsTo(description_);
        implementation_->setCallee(function);
    }
    implementation_->setThread(et, owner ? owner : implementation_->getOwner());
}

void OperationBase::addArgument(const std::string& name, const std::string& text) {
    description_->texts.push_back(name);
    description_->texts.push_back(text);
}

OperationInterfacePart* OperationBase::makePart(bool callOnly) const {
    return new internal::OperationPart(description_, implementation_, *table_, callOnly);
}

}  // namespace RTT::base
