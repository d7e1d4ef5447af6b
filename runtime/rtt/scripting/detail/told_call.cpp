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

ToldCall::ToldCall(internal::DataSource<bool>* call, oroforge::diag::Location where, std::string line, bool ignored)
    : call_(call), where_(std::move(where)), line_(std::move(line)), ignored_(ignored) {}

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
    // Not from the file, which would be read by the thread of the component, within its step.
    oroforge::diag::SourceCache sources;
    sources.add(where_.file, line_.empty() ? line_ : std::string(where_.line - 1, '\n') + line_);
    std::ostringstream text;
    oroforge::diag::print(text, sink, sources);
    std::string line = text.str();
    line.pop_back();  // its last end of line
    internal::logLocated(Error, line);
}

std::string lineOf(const std::string& text, unsigned line) {
    std::istringstream in(text);
    std::string found;
    while (line-- != 0 && std::getline(in, found)) {
    }
    return found;
}

ToldCall* ToldCall::clone() const { return new ToldCall(call_->clone(), where_, line_, ignored_); }

ToldCall* ToldCall::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const {
    base::DataSourceBase*& made = alreadyCloned[this];
    if (!made) made = new ToldCall(call_->copy(alreadyCloned), where_, line_, ignored_);
    return static_cast<ToldCall*>(made);
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
