// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/script_syntax.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/check.hpp>
#include <rtt/scripting/detail/syntax/parser.hpp>
#include <rtt/scripting/detail/service/script_checker.hpp>
#include <rtt/scripting/detail/service/script_contents.hpp>
#include <rtt/scripting/detail/syntax/script_text.hpp>

namespace RTT::scripting::detail {

void checkSyntax(const std::string& file, oroforge::diag::Sink& sink) {
    if (const auto text = readScript(file, sink)) (void)parse(*text, file, sink);
}

namespace {

/** A forecast that knows no operation. */
class NoForecast final : public CallForecast {
public:
    CallProblem foresee(const ForeseenCall&, Expectations&) override { return {}; }
};

}  // namespace

void checkAlone(const std::string& file, const std::string& component, Contents contents, oroforge::diag::Sink& sink) {
    const auto text = readScript(file, sink);
    if (!text) return;
    TaskContext stand(component);
    // The real component may have other operations of these names.
    for (const std::string& operation : stand.provides()->getOperationNames())
        stand.provides()->removeOperation(operation);
    stand.provides()->addService(Service::shared_ptr(new ScriptingService(&stand)));
    Expectations expected;
    expected.anything();
    NoForecast nothing;
    const auto source = std::make_shared<SourceFile>(file, *text, nullptr);
    ScriptChecker checker(stand, source, nothing, expected);
    const oroforge::diag::Sink found = checker.check();
    for (const oroforge::diag::Diagnostic& each : found.all()) sink.add(each);
    if (found.hadErrors()) return;
    checkContents(source->tree.items, contents, [&](ast::Place at, const char* code, const std::string& message) {
        sink.error({file, at.line, at.column}, code, message);
    });
}

}  // namespace RTT::scripting::detail
