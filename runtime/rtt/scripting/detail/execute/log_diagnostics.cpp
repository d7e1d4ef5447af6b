// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/execute/log_diagnostics.hpp>

#include <rtt/internal/diagnostic_taker.hpp>
#include <rtt/internal/located_log.hpp>

#include <diag/print.hpp>

#include <sstream>
#include <string>

namespace RTT::scripting::detail {

namespace diag = oroforge::diag;

void logDiagnostics(const diag::Sink& sink, diag::SourceCache& sources) {
    if (internal::takeDiagnostics(sink)) return;
    std::ostringstream errors, warnings;
    for (const diag::Diagnostic& diagnostic : sink.sorted())
        diag::print(diagnostic.severity == diag::Severity::Error ? errors : warnings, diagnostic, sources);
    const auto write = [](LoggerLevel level, std::string text) {
        if (text.empty()) return;
        text.pop_back();  // its last end of line
        internal::logLocated(level, text);
    };
    write(Warning, warnings.str());
    write(Error, errors.str());
}

}  // namespace RTT::scripting::detail
