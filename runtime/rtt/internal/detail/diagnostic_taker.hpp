// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_DIAGNOSTIC_TAKER_HPP
#define ORO_INTERNAL_DETAIL_DIAGNOSTIC_TAKER_HPP

#include <rtt/rtt-config.h>

#include <diag/sink.hpp>

namespace RTT {
namespace internal {

/** Gets what is reported of files, in whatever thread. True if it is not to be told in another way. */
using DiagnosticTaker = bool (*)(const oroforge::diag::Sink& sink);

/** For a program that writes a document of all that is reported; null: nobody does. Any thread. */
RTT_API void setDiagnosticTaker(DiagnosticTaker taker) noexcept;

/** For those who report: true if nothing else has to tell this. Any thread; not real-time safe. */
RTT_API bool takeDiagnostics(const oroforge::diag::Sink& sink);

}  // namespace internal
}  // namespace RTT

#endif
