// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DIAGNOSTIC_TAKER_HPP
#define ORO_INTERNAL_DIAGNOSTIC_TAKER_HPP

#include <rtt/rtt-config.h>

namespace oroforge::diag {
class Sink;
}

namespace RTT {
namespace internal {

/** Receives diagnostics about files, in any thread. Returns true if they must not be written elsewhere. */
using DiagnosticTaker = bool (*)(const oroforge::diag::Sink& sink);

/** For a program that writes all diagnostics into a document; null removes the taker. Any thread. */
RTT_API void setDiagnosticTaker(DiagnosticTaker taker) noexcept;

/** Offers diagnostics to the program. True if the caller must not write them. Any thread; not real-time safe. */
RTT_API bool takeDiagnostics(const oroforge::diag::Sink& sink);

}  // namespace internal
}  // namespace RTT

#endif
