// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/check.hpp>

#include <rtt/internal/diagnostic_taker.hpp>
#include <rtt/scripting/detail/service/script_checker.hpp>
#include <rtt/scripting/detail/syntax/script_text.hpp>

#include <diag/print.hpp>

namespace RTT::scripting {

namespace {

/** A forecast that knows no operation. */
class NoForecast final : public CallForecast {
public:
    CallProblem foresee(const ForeseenCall&, Expectations& expected) override {
        expected.anything();
        return {};
    }
};

bool check(const std::string& text, const std::string& name, TaskContext& component, std::ostream& messages,
           CallForecast& forecast, Expectations& expected) {
    oroforge::diag::SourceCache sources;
    sources.add(name, text);
    const auto file = std::make_shared<detail::SourceFile>(name, text, nullptr);
    const oroforge::diag::Sink found = detail::ScriptChecker(component, file, forecast, expected).check();
    if (!internal::takeDiagnostics(found)) oroforge::diag::print(messages, found, sources);
    return !found.hadErrors();
}

}  // namespace

CallForecast::~CallForecast() = default;

bool checkScript(const std::string& file, TaskContext& component, std::ostream& messages) {
    NoForecast nothing;
    Expectations expected;
    return checkScript(file, component, messages, nothing, expected);
}

bool checkScript(const std::string& file, TaskContext& component, std::ostream& messages, CallForecast& forecast,
                 Expectations& expected) {
    oroforge::diag::Sink sink;
    if (const auto text = detail::readScript(file, sink))
        return check(*text, file, component, messages, forecast, expected);
    if (!internal::takeDiagnostics(sink)) oroforge::diag::print(messages, sink);
    return false;
}

bool checkScriptText(const std::string& text, const std::string& name, TaskContext& component, std::ostream& messages) {
    NoForecast nothing;
    Expectations expected;
    return check(text, name, component, messages, nothing, expected);
}

}  // namespace RTT::scripting
