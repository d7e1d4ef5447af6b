// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_DIAGNOSTIC_TAKER_HPP
#define ORO_INTERNAL_DETAIL_DIAGNOSTIC_TAKER_HPP

#include <rtt/rtt-config.h>

#include <diag/sink.hpp>

namespace RTT {
namespace internal {

/** Receives what a part reports about files, in any thread. Returns true if that part must not write it elsewhere, too. */
using DiagnosticTaker = bool (*)(const oroforge::diag::Sink& sink);

/** A program that writes a document of all reports sets this; null removes it. Any thread. */
RTT_API void setDiagnosticTaker(DiagnosticTaker taker) noexcept;

/** Offers a report to the program. Returns true if the caller must not write it elsewhere, too. Any thread; not real-time safe. */
RTT_API bool takeDiagnostics(const oroforge::diag::Sink& sink);

}  // namespace internal
}  // namespace RTT

#endif
