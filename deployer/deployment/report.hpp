// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_REPORT_HPP
#define OROFORGE_DEPLOYMENT_REPORT_HPP

#include <diag/sink.hpp>

namespace OCL::deploy {

/** Writes diagnostics with their source lines to standard error, and a line for each to the log file. If a function
    takes all diagnostics of the process, gives them to it instead. */
void report(const oroforge::diag::Sink& sink);

/** Writes a line for each diagnostic to the log file only. */
void logToFile(const oroforge::diag::Sink& sink);

}  // namespace OCL::deploy

#endif
