// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_LOG_DIAGNOSTICS_HPP
#define ORO_SCRIPTING_DETAIL_LOG_DIAGNOSTICS_HPP

#include <diag/sink.hpp>
#include <diag/source_cache.hpp>

namespace RTT::scripting::detail {

/** Logs one message with all errors and one with all other diagnostics, with source lines. */
void logDiagnostics(const oroforge::diag::Sink& sink, oroforge::diag::SourceCache& sources);

}  // namespace RTT::scripting::detail

#endif
