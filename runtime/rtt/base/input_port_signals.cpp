// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How an input port tells its component of new samples.
//
// A channel signals inside the writer's Reclaimer::Guard. The component may run any code in answer (a sequential one
// runs its step), so it is told when the writer has left the guard; until then, and while it is being told, the port is
// pinned and its destructor waits. A port may be destroyed by what its own signal started: then it does not wait for itself.
#include <rtt/base/InputPortInterface.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/PortEndpoint.hpp>
#include <rtt/internal/Reclaimer.hpp>

#include <chrono>
#include <exception>
#include <thread>

namespace RTT {
namespace base {

namespace {

/** The signals this thread is delivering, innermost first. */
struct Delivery {
    InputPortInterface* port;  // null when the port was destroyed meanwhile
    Delivery* outer;
};
thread_local Delivery* deliveries __attribute__((tls_model("initial-exec"))) = nullptr;

}  // namespace

void InputPortInterface::signalInterface(bool on) { endpoint().setSignals(on); }

bool InputPortInterface::signalsInterface() const { return endpoint().signals(); }

void InputPortInterface::signalLater() {
    // seq_cst, like newDataAvailable()'s look at the interface: either finishSignals() sees this pin, or we see that the
    // port was taken out of its interface before.
    pinned_.fetch_add(1, std::memory_order_seq_cst);
    if (!internal::Reclaimer::defer(&InputPortInterface::deliverSignal, this)) deliverSignal(this);
}

void InputPortInterface::deliverSignal(void* self) {
    Delivery delivery{static_cast<InputPortInterface*>(self), deliveries};
    deliveries = &delivery;
    try {
        delivery.port->newDataAvailable();
    } catch (const std::exception& e) {
        log(Error) << "exception while a component was told of new data: " << e.what() << endlog();
    } catch (...) {
        log(Error) << "unknown exception while a component was told of new data" << endlog();
    }
    deliveries = delivery.outer;
    // Release: all we did with the port happens before its destructor goes on.
    if (delivery.port) delivery.port->pinned_.fetch_sub(1, std::memory_order_release);
}

void InputPortInterface::finishSignals() {
    int own = 0;
    for (Delivery* d = deliveries; d; d = d->outer)
        if (d->port == this) ++own;
    while (pinned_.load(std::memory_order_seq_cst) > own) std::this_thread::sleep_for(std::chrono::microseconds(20));
}

void InputPortInterface::forgetSignals() {
    finishSignals();
    for (Delivery* d = deliveries; d; d = d->outer)
        if (d->port == this) d->port = nullptr;
}

void InputPortInterface::newDataAvailable() {
    DataFlowInterface* iface = getInterface();
    if (iface && signalsInterface()) iface->dataOnPort(this);
}

}  // namespace base
}  // namespace RTT
