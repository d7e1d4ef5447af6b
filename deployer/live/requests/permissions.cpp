// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "permissions.hpp"

#include "failure.hpp"

#include <rtt/internal/calls/standard_operations.hpp>

#include <algorithm>
#include <array>

namespace OCL::live {
namespace {

template <std::size_t N>
bool isOneOf(const std::array<const char*, N>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/** Whether it executes code or commands that the caller gives, loads libraries, or reads and writes any files. */
bool leadsOutside(const Asked& asked, const Found& at) {
    constexpr std::array services = {"scripting", "marshalling", "os", "Lua", "LuaTLSF"};
    constexpr std::array ofLuaComponents = {"exec_str", "exec_file"};
    constexpr std::array ofDeployers = {
        "import",      "kickOut", "kickStart",     "loadComponents", "loadConfiguration", "loadConfigurationString",
        "loadLibrary", "path",    "reloadLibrary", "runScript"};
    const std::string& name = at.rest.front();
    return isOneOf(services, at.service->getName()) || isOneOf(ofLuaComponents, name) ||
           (at.gate && at.gate == asked.root.gate && isOneOf(ofDeployers, name));
}

}  // namespace

std::string whyNotCalled(const Asked& asked, const Found& at) {
    const Rights& rights = asked.caller.rights;
    const std::string &name = at.rest.front(), whole = "operation '" + at.pathWith(name) + "'";
    const auto* const standard = RTT::internal::standardOperation(name);
    const bool changesState = at.component && at.service == at.component->provides() && at.rest.size() == 1 &&
                              standard && (!standard->isQuery || name.compare(0, 3, "set") == 0);
    const std::string lifecycle = "; the deployer's option --web-allow=lifecycle allows it";
    if (!rights.lifecycle && changesState)
        return whole + " changes the state of its component, which is not allowed here" + lifecycle;
    if (!rights.console && leadsOutside(asked, at))
        return whole +
               " executes code or commands, or uses files; only 'oro' on the same computer, without --url, may call it";
    if (!rights.lifecycle && at.gate && at.gate == asked.root.gate)
        return whole + " belongs to the deployer, which changes all components, and is not allowed here" + lifecycle;
    return "";
}

void checkSet(const Asked& asked, const FoundValue& found) {
    constexpr std::array ofLuaComponents = {"lua_string", "lua_file"};
    const std::string name = found.whole.substr(found.whole.rfind('.') + 1);
    if (!asked.caller.rights.console && found.gate == asked.root.gate && name == "RTT_COMPONENT_PATH")
        throw Failure(kNotAllowed, "'" + found.whole +
                                       "' is where libraries are loaded from; only 'oro' on the same computer, without "
                                       "--url, may set it");
    if (!asked.caller.rights.console && isOneOf(ofLuaComponents, name))
        throw Failure(kNotAllowed, "'" + found.whole +
                                       "' is code that the component executes; only 'oro' on the same computer, "
                                       "without --url, may set it");
}

}  // namespace OCL::live
