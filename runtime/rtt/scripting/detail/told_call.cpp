// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/told_call.hpp>

#include <rtt/internal/FailureReport.hpp>
#include <rtt/internal/located_log.hpp>

#include <diag/print.hpp>

#include <sstream>
#include <stdexcept>
#include <utility>

namespace RTT {
namespace scripting {
namespace detail {

using internal::FailureReport;

ToldCall::ToldCall(internal::DataSource<bool>* call, oroforge::diag::Location where, bool ignored)
    : call_(call), where_(std::move(where)), ignored_(ignored) {}

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

/** Also of a call that returns true: what it has to say was kept from the log. */
void ToldCall::tell(const std::string& reasons) const {
    if (ignored_ && FailureReport::isStrict() && !value()) throw std::runtime_error(reasons);
    oroforge::diag::Sink sink;
    sink.warning(where_, "OPS420", reasons);
    std::ostringstream text;
    oroforge::diag::print(text, sink);
    std::string line = text.str();
    line.pop_back();  // its last end of line
    internal::logLocated(Error, line);
}

ToldCall* ToldCall::clone() const { return new ToldCall(call_->clone(), where_, ignored_); }

ToldCall* ToldCall::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const {
    base::DataSourceBase*& made = alreadyCloned[this];
    if (!made) made = new ToldCall(call_->copy(alreadyCloned), where_, ignored_);
    return static_cast<ToldCall*>(made);
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
