// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_REPORT_HPP
#define OROFORGE_DEPLOYMENT_REPORT_HPP

#include <diag/sink.hpp>

namespace OCL::deploy {

/** Writes diagnostics with their source lines to standard error, and one line for each to the log file; or gives them to who
    takes all diagnostics of the process. */
void report(const oroforge::diag::Sink& sink);

/** One line for each to the log file only. */
void logToFile(const oroforge::diag::Sink& sink);

}  // namespace OCL::deploy

#endif
