// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "report.hpp"

#include <diag/print.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/detail/diagnostic_taker.hpp>

#include <iostream>

namespace OCL::deploy {
namespace {

/** Keeps the log off the console, where the same is said better, for the life time of this object. */
class FileLogOnly {
public:
    FileLogOnly() : wasOn_(reachesConsole()) {
        if (wasOn_) RTT::Logger::Instance()->mayLogStdOut(false);
    }
    ~FileLogOnly() {
        if (wasOn_) RTT::Logger::Instance()->mayLogStdOut(true);
    }

private:
    /** The logger answers for the level of the line that was begun last: one that nobody wants to see reaches nothing. */
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
