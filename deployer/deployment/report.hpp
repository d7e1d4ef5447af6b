// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_REPORT_HPP
#define OROFORGE_DEPLOYMENT_REPORT_HPP

#include <diag/sink.hpp>

namespace OCL::deploy {

/** Writes diagnostics with their source lines to standard error, and one line for each to the log file. */
void report(const oroforge::diag::Sink& sink);

}  // namespace OCL::deploy

#endif
