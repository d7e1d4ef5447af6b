// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_LOG_DIAGNOSTICS_HPP
#define ORO_SCRIPTING_DETAIL_LOG_DIAGNOSTICS_HPP

#include <diag/sink.hpp>
#include <diag/source_cache.hpp>

namespace RTT::scripting::detail {

/** One message of all errors, and one of all that is no error, with the lines of the texts. */
void logDiagnostics(const oroforge::diag::Sink& sink, oroforge::diag::SourceCache& sources);

}  // namespace RTT::scripting::detail

#endif
