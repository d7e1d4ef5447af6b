// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "port_faults.hpp"

#include <algorithm>

#include <diag/nearest_match.hpp>

namespace OCL::deploy {

diag::Diagnostic& reportUnknownPort(const std::string& component, const Text& port,
                                    const std::vector<std::string>& known, diag::Sink& sink) {
    return sink.error(
        port.where, "DEP040",
        "component '" + component + "' has no port '" + port.value + "'" + diag::didYouMean(port.value, known));
}

void reportOtherType(const std::string& connection, const ConnectedPort& first, const ConnectedPort& other,
                     diag::Sink& sink) {
    sink.error(other.where, "DEP041",
               "port '" + other.name + "' of type '" + other.type + "' cannot take part in connection '" + connection +
                   "' of type '" + first.type + "'")
        .note(first.where, "port '" + first.name + "' gives the connection its type");
}

void checkDirections(const std::string& connection, const std::vector<ConnectedPort>& ports, diag::Sink& sink) {
    const auto outputs =
        std::count_if(ports.begin(), ports.end(), [](const ConnectedPort& one) { return one.isOutput; });
    if (outputs != 0 && outputs != static_cast<std::ptrdiff_t>(ports.size())) return;
    const diag::Location& where = ports.front().where;
    diag::Diagnostic& report =
        outputs == 0 ? sink.error(where, "DEP042", "no output port takes part in connection '" + connection + "'")
                     : sink.warning(where, "DEP042", "no input port takes part in connection '" + connection + "'");
    for (const ConnectedPort& one : ports)
        report.note(one.where, "port '" + one.name + "' is an " + (one.isOutput ? "output" : "input"));
}

}  // namespace OCL::deploy
