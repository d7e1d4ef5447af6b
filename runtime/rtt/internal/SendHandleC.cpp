// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SendHandleC.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/Logger.hpp>

#include <exception>

namespace RTT::internal {

namespace {

OperationInterfacePart::Args withHandle(const SendHandleC::Source& handle,
                                        const OperationInterfacePart::Args& variables) {
    OperationInterfacePart::Args all{handle};
    all.insert(all.end(), variables.begin(), variables.end());
    return all;
}

DataSource<bool>::shared_ptr constant(bool value) { return new ConstantDataSource<bool>(value); }

/** The source that collects. Throws if the arguments do not fit. */
SendHandleC::Source collecting(const SendHandleC& handle, const OperationInterfacePart::Args& variables, bool wait) {
    if (!handle.getSendHandleDataSource() || !handle.getOrp()) throw invalid_handle_exception();
    return handle.getOrp()->produceCollect(withHandle(handle.getSendHandleDataSource(), variables), constant(wait));
}

}  // namespace

SendHandleC::SendHandleC(Source handle, const OperationInterfacePart* part, const std::string& name)
    : handle_(handle), part_(OperationInterfacePart::hold(part)), name_(name) {}

SendHandleC::~SendHandleC() {
    if (!auto_collect_ || !handle_) return;
    try {
        part_->produceCollect(withHandle(handle_, {}), constant(true))->evaluate();
    } catch (const std::exception& e) {
        log(Error) << "collecting operation '" << name_ << "' failed: " << e.what() << endlog();
    }
}

SendHandleC& SendHandleC::arg(Source variable) {
    arguments_.push_back(variable);
    return *this;
}

SendHandleC& SendHandleC::arg(base::AttributeBase* attribute) {
    return arg(attribute ? attribute->getDataSource() : Source());
}

void SendHandleC::check() const { collecting(*this, arguments_, false); }

bool SendHandleC::ready() const {
    try {
        check();
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

SendStatus SendHandleC::fetch(bool wait) {
    Source collect;
    try {
        collect = collecting(*this, arguments_, wait);
    } catch (const std::exception& e) {
        log(Error) << "operation '" << name_ << "' cannot be collected: " << e.what() << endlog();
        return SendFailure;
    }
    auto* status = DataSource<SendStatus>::narrow(collect.get());
    return status ? status->get() : SendFailure;
}

}  // namespace RTT::internal
