// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/call_source.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/OperationBase.hpp>
#include <rtt/internal/calls/operation_table.hpp>
#include <rtt/internal/engine/interruption.hpp>

#include <stdexcept>

namespace RTT::internal {

namespace {

/** The calling thread would execute the operation itself, on what is left of its component. A sent call is refused. */
bool isOrphan(const base::OperationCallerInterface& caller) {
    return caller.getThread() == ClientThread && caller.callee() && !caller.ready();
}

}  // namespace

void throwNoValue() { throw std::logic_error("there is no result, and its type has no default value"); }

GenericCall::GenericCall(boost::shared_ptr<base::OperationCallerInterface> caller, const OperationTable& table,
                         std::vector<Source> arguments, std::shared_ptr<const base::OperationDescription> description)
    : caller_(std::move(caller)),
      table_(&table),
      arguments_(std::move(arguments)),
      description_(std::move(description)),
      addresses_(arguments_.size() + 1) {}

GenericCall::GenericCall(const GenericCall&) = default;
GenericCall::GenericCall(GenericCall&&) noexcept = default;
GenericCall::~GenericCall() = default;

bool GenericCall::evaluateArguments() const {
    for (std::size_t i = 0; i != arguments_.size(); ++i) {
        base::DataSourceBase& source = *arguments_[i];
        failed_ = i;
        if (!source.evaluate()) return false;
        addresses_[i] =
            table_->types[i + 1].isOutput() ? source.getRawPointer() : const_cast<void*>(source.getRawConstPointer());
        if (!addresses_[i]) return false;
    }
    return true;
}

bool GenericCall::invoke(void* result) const {
    if (!evaluateArguments()) return false;
    if (isOrphan(*caller_))
        throw SendError(SendFailure, describe(caller_->callee()) +
                                         " was not executed: the component that provides it was destroyed");
    Interruption* const interruption = Interruption::ofThisThread();
    const Interruption::Region called(interruption && !caller_->isSend() ? interruption : nullptr,
                                      Interruption::Region::Native);
    try {
        table_->invoke(*caller_, addresses_.data(), result);
    } catch (const Interrupted&) {
        throw;  // the interruption is meant for the caller
    } catch (const std::exception& thrown) {
        threw(thrown.what());
        throw;
    } catch (...) {
        threw("something that is no std::exception");
        throw;
    }
    for (std::size_t i = 0; i != arguments_.size(); ++i)
        if (table_->types[i + 1].isOutput()) arguments_[i]->updated();
    return true;
}

void GenericCall::threw(const char* what) const {
    // The engine that executes a sent call puts the component into Exception itself.
    if (!caller_->isSend()) caller_->ownerThrew(what);
}

bool GenericCall::send(SentCall::shared_ptr& sent) const {
    sent = nullptr;
    if (!evaluateArguments()) return false;
    if (isOrphan(*caller_)) return true;
    sent = table_->send(*caller_, addresses_.data());
    return true;
}

std::string GenericCall::whyNot() const {
    return "operation '" + description_->name + "' was not called: its argument " + std::to_string(failed_ + 1) +
           " could not be evaluated";
}

bool GenericCall::report() const {
    log(Error) << whyNot() << endlog();
    return false;
}

void GenericCall::fail() const { throw std::runtime_error(whyNot()); }

GenericCall GenericCall::copy(CopyMap& cloned) const {
    std::vector<Source> arguments;
    for (const Source& argument : arguments_) arguments.push_back(argument->copy(cloned));
    return GenericCall(caller_, *table_, std::move(arguments), description_);
}

template class CallSource<void>;
template class CallSource<bool>;
template class CallSource<int>;
template class CallSource<unsigned>;
template class CallSource<double>;
template class CallSource<std::string>;
template class CallSource<FlowStatus>;
template class CallSource<WriteStatus>;

}  // namespace RTT::internal
