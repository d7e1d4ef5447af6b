// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/diagnostic_taker.hpp>

#include <diag/sink.hpp>

#include <atomic>

namespace RTT::internal {

namespace {

std::atomic<DiagnosticTaker> current{nullptr};

}  // namespace

void setDiagnosticTaker(DiagnosticTaker taker) noexcept { current.store(taker); }

bool takeDiagnostics(const oroforge::diag::Sink& sink) {
    const DiagnosticTaker taker = current.load();
    return taker && !sink.empty() && taker(sink);
}

}  // namespace RTT::internal
