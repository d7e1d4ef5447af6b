// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: only whether the port signals.
#ifndef OROFORGE_MODEL_PORT_ENDPOINT_HPP
#define OROFORGE_MODEL_PORT_ENDPOINT_HPP

#include <atomic>

namespace RTT {
namespace internal {

class PortEndpoint {
public:
    void setSignals(bool on) { signals_.store(on, std::memory_order_relaxed); }
    bool signals() const { return signals_.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> signals_{false};
};

}  // namespace internal
}  // namespace RTT
#endif
