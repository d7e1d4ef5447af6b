// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "report.hpp"

#include <diag/print.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/diagnostic_taker.hpp>

#include <iostream>

namespace OCL::deploy {
namespace {

/** While it exists, keeps the log off the console, where diagnostics are printed with more detail. */
class FileLogOnly {
public:
    FileLogOnly() : wasOn_(reachesConsole()) {
        if (wasOn_) RTT::Logger::Instance()->mayLogStdOut(false);
    }
    ~FileLogOnly() {
        if (wasOn_) RTT::Logger::Instance()->mayLogStdOut(true);
    }

private:
    /** Begins a line of level Fatal, because the logger answers for the level of the last line. */
    static bool reachesConsole() {
        RTT::log(RTT::Fatal);
        return RTT::Logger::Instance()->mayLogStdOut();
    }

    const bool wasOn_;
};

}  // namespace

void report(const oroforge::diag::Sink& sink) {
    if (sink.empty() || RTT::internal::takeDiagnostics(sink)) return;
    oroforge::diag::print(std::cerr, sink);
    std::cerr.flush();
    logToFile(sink);
}

void logToFile(const oroforge::diag::Sink& sink) {
    const FileLogOnly quiet;
    for (const oroforge::diag::Diagnostic& diagnostic : sink.sorted())
        RTT::log(diagnostic.severity == oroforge::diag::Severity::Error ? RTT::Error : RTT::Warning)
            << oroforge::diag::toString(diagnostic) << RTT::endlog();
}

}  // namespace OCL::deploy
