// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/detail/call_handles.hpp>

#include <rtt/internal/calls/operation_table.hpp>

namespace RTT::internal::detail {

CollectSource::CollectSource(const OperationTable& table, Handle handle, Variables variables,
                             DataSource<bool>::shared_ptr blocking)
    : table_(&table), handle_(std::move(handle)), variables_(std::move(variables)), blocking_(std::move(blocking)) {}

SendStatus CollectSource::get() const {
    const SentCall::shared_ptr call = handle_->get();
    // The results of another operation's call would not fit the variables.
    const SentCall* const sent = call.get();
    const bool fits = sent != nullptr && (variables_.empty() || typeid(*sent) == *table_->sentType);
    if (!fits) return status_ = SendFailure;
    status_ = !blocking_ || blocking_->get() ? call->collect() : call->collectIfDone();
    if (status_ == SendSuccess && !variables_.empty() && !fill(*call)) status_ = CollectFailure;
    return status_;
}

bool CollectSource::fill(SentCall& call) const {
    auto variable = variables_.begin();
    bool all = true;
    if (const void* result = call.resultAddress()) all = (*variable++)->assignValue(result);
    for (unsigned i = 0; i != table_->arity; ++i)
        if (table_->types[i + 1].isOutput()) all = (*variable++)->assignValue(call.argumentAddress(i)) && all;
    for (const auto& filled : variables_) filled->updated();
    return all;
}

CollectSource* CollectSource::copy(CopyMap& cloned) const {
    Variables variables;
    for (const auto& variable : variables_) variables.push_back(variable->copy(cloned));
    return new CollectSource(*table_, handle_->copy(cloned), variables, blocking_ ? blocking_->copy(cloned) : nullptr);
}

}  // namespace RTT::internal::detail
