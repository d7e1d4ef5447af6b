// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/told_call.hpp>

#include <rtt/internal/calls/failure_report.hpp>

#include <utility>

namespace RTT::scripting::detail {

using internal::FailureReport;

ToldCall::ToldCall(internal::DataSource<bool>* call, CallPlace place, bool ignored)
    : call_(call), place_(std::move(place)), ignored_(ignored) {}

bool ToldCall::evaluate() const {
    std::string reasons;
    {
        const FailureReport report;
        if (!call_->evaluate()) return false;
        reasons = report.reasons();
    }
    if (!reasons.empty()) tell(reasons);
    return true;
}

bool ToldCall::get() const {
    evaluate();
    return value();
}

/** Also logs the reasons of a call that returns true, because they were kept out of the log. */
void ToldCall::tell(const std::string& reasons) const {
    if (ignored_ && FailureReport::isStrict() && !value()) throw FailedCall(place_, reasons);
    logFailure(oroforge::diag::Severity::Warning, place_, reasons);
}

ToldCall* ToldCall::clone() const { return new ToldCall(call_->clone(), place_, ignored_); }

ToldCall* ToldCall::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const {
    base::DataSourceBase*& made = alreadyCloned[this];
    if (!made) made = new ToldCall(call_->copy(alreadyCloned), place_, ignored_);
    return static_cast<ToldCall*>(made);
}

}  // namespace RTT::scripting::detail
