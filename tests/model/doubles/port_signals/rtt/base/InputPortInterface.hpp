// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: an input port as far as telling its component of new samples goes.
#ifndef OROFORGE_MODEL_INPUT_PORT_INTERFACE_HPP
#define OROFORGE_MODEL_INPUT_PORT_INTERFACE_HPP

#include <rtt/internal/flow/deferred_calls.hpp>
#include <rtt/internal/flow/port_endpoint.hpp>

#include <atomic>

namespace RTT {
class DataFlowInterface;
namespace base {

class InputPortInterface {
public:
    ~InputPortInterface() { forgetSignals(); }
    void signalInterface(bool on);
    bool signalsInterface() const;
    void newDataAvailable();
    void signalLater();
    void finishSignals(bool executesMessages = false);
    DataFlowInterface* getInterface() const { return interface_.load(std::memory_order_seq_cst); }
    void setInterface(DataFlowInterface* iface) { interface_.store(iface, std::memory_order_seq_cst); }

private:
    static void deliverSignal(void*& self);
    bool unpin();
    void forgetSignals();
    internal::PortEndpoint& endpoint() const { return endpoint_; }

    static constexpr std::uint32_t kAgain = 1u << 31;
    std::atomic<std::uint32_t> pinned_{0};
    internal::DeferredCalls::Call signal_;
    std::atomic<DataFlowInterface*> interface_{nullptr};
    mutable internal::PortEndpoint endpoint_;
};

}  // namespace base
}  // namespace RTT
#endif
