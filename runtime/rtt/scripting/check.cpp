// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/check.hpp>

#include <rtt/scripting/detail/script_checker.hpp>
#include <rtt/scripting/detail/script_text.hpp>

#include <diag/print.hpp>

namespace RTT {
namespace scripting {

bool checkScript(const std::string& file, TaskContext& component, std::ostream& messages) {
    oroforge::diag::Sink sink;
    if (const auto text = detail::readScript(file, sink)) return checkScriptText(*text, file, component, messages);
    oroforge::diag::print(messages, sink);
    return false;
}

bool checkScriptText(const std::string& text, const std::string& name, TaskContext& component, std::ostream& messages) {
    oroforge::diag::SourceCache sources;
    sources.add(name, text);
    const oroforge::diag::Sink found =
        detail::ScriptChecker(component, std::make_shared<detail::SourceFile>(name, text, nullptr)).check();
    oroforge::diag::print(messages, found, sources);
    return !found.hadErrors();
}

}  // namespace scripting
}  // namespace RTT
