// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: an input port as far as telling its component of new samples goes.
#ifndef OROFORGE_MODEL_INPUT_PORT_INTERFACE_HPP
#define OROFORGE_MODEL_INPUT_PORT_INTERFACE_HPP

#include <rtt/internal/PortEndpoint.hpp>

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
    void finishSignals();
    DataFlowInterface* getInterface() const { return interface_.load(std::memory_order_seq_cst); }
    void setInterface(DataFlowInterface* iface) { interface_.store(iface, std::memory_order_seq_cst); }

private:
    static void deliverSignal(void* self);
    void forgetSignals();
    internal::PortEndpoint& endpoint() const { return endpoint_; }

    std::atomic<int> pinned_{0};
    std::atomic<DataFlowInterface*> interface_{nullptr};
    mutable internal::PortEndpoint endpoint_;
};

}  // namespace base
}  // namespace RTT
#endif
