// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/send_handle_servant.hpp>

#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/transports/corba/detail/call_arguments.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <exception>
#include <utility>

namespace RTT::corba::detail {

namespace {

/** CCollectFailure is the first of both. */
CSendStatus onWire(SendStatus status) { return static_cast<CSendStatus>(static_cast<int>(status) + 2); }

}  // namespace

SendHandleServant::SendHandleServant(Served served, OperationInterfacePart::shared_constptr part,
                                     internal::SendHandleC handle)
    : served_(std::move(served)), part_(std::move(part)), collected_(collectedBy(*part_)), handle_(std::move(handle)) {
    for (const base::DataSourceBase::shared_ptr& variable : collected_) handle_.arg(variable);
}

SendStatus SendHandleServant::fetch(bool wait) {
    served_->keep(this);
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
        return wait ? handle_.collect() : handle_.collectIfDone();
    } catch (const std::exception& error) {
        throw CCallError(error.what());
    }
}

CSendStatus SendHandleServant::fetch(CAnyArguments_out args, bool wait) {
    CAnyArguments_var values = new CAnyArguments();
    const SendStatus status = fetch(wait);
    if (status == SendSuccess) setValues(values.inout(), collected_);
    args = values._retn();
    return onWire(status);
}

CSendStatus SendHandleServant::collect(CAnyArguments_out args) { return fetch(args, true); }
CSendStatus SendHandleServant::collectIfDone(CAnyArguments_out args) { return fetch(args, false); }
CSendStatus SendHandleServant::checkStatus() {
    try {
        return onWire(fetch(false));
    } catch (const CCallError&) {
        return CSendSuccess;  // collecting gives the error
    }
}

CORBA::Any* SendHandleServant::ret() {
    return fetch(false) == SendSuccess && !collected_.empty() ? newAny(collected_.front()) : new CORBA::Any();
}

void SendHandleServant::checkArguments(const CAnyArguments& args) {
    if (args.length() != collected_.size())
        throw CWrongNumbArgException(static_cast<CORBA::Long>(collected_.size()),
                                     static_cast<CORBA::Long>(args.length()));
    for (CORBA::ULong i = 0; i != args.length(); ++i) {
        const types::TypeInfo* const type = part_->getCollectType(i + 1);
        if (!type || !valueOf(args[i], *type))
            throw CWrongTypeArgException(static_cast<CORBA::Long>(i + 1),
                                         type ? type->getTypeName().c_str() : "unknown_t", typeName(args[i]).c_str());
    }
}

void SendHandleServant::dispose() { served_->deactivate(this); }

}  // namespace RTT::corba::detail
