// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How an input port signals new samples to its component.
//
// A channel signals inside the writer's Reclaimer::Guard. The component may run any code in response (a sequential one
// runs its step), so the signal is delivered when the writer has left the guard. Until the delivery ends the port is
// pinned and its destructor waits. Code started by its own signal, or by that of another port of the same write, may
// destroy the port: a thread does not wait for itself, and drops its pending signals of the port.
//
// A pending signal needs a place. The port has one, for the thread that pins it while no other does. Others take one of
// the few that each thread has. If those are in use, too, the thread that unpins the port last delivers once more.
#include <rtt/base/InputPortInterface.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/flow/detail/waiting.hpp>
#include <rtt/internal/flow/port_endpoint.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <exception>

namespace RTT::base {

using internal::detail::Waiting;

void InputPortInterface::signalInterface(bool on) { endpoint().setSignals(on); }

bool InputPortInterface::signalsInterface() const { return endpoint().signals(); }

void InputPortInterface::signalLater() {
    internal::DeferredCalls& calls = internal::Reclaimer::deferred();
    // seq_cst, like newDataAvailable()'s load of the interface: either finishSignals() sees this pin, or we see that
    // the port was taken out of its interface before. It also acquires the place in the port from its last user.
    std::uint32_t before = pinned_.fetch_add(1, std::memory_order_seq_cst);
    if (calls.add((before & ~kAgain) == 0 ? &signal_ : nullptr, &InputPortInterface::deliverSignal, this)) return;
    for (std::uint32_t now = pinned_.load(std::memory_order_acquire);;) {
        if ((now & ~kAgain) == 1) {  // all other pins are gone meanwhile
            (void)calls.add(&signal_, &InputPortInterface::deliverSignal, this);
            return;
        }
        // A thread that delivers once more sees our sample, because it sees this, and so the pin.
        if (pinned_.compare_exchange_weak(now, (now - 1) | kAgain, std::memory_order_seq_cst,
                                          std::memory_order_acquire))
            return Waiting::mayBeOver();
    }
}

void InputPortInterface::deliverSignal(void*& self) {
    do {
        try {
            static_cast<InputPortInterface*>(self)->newDataAvailable();
        } catch (const std::exception& e) {
            log(Error) << "exception while a component was told of new data: " << e.what() << endlog();
        } catch (...) {
            log(Error) << "unknown exception while a component was told of new data" << endlog();
        }
        // Null: the port was destroyed meanwhile, or another thread took the call over.
    } while (self && !static_cast<InputPortInterface*>(self)->unpin());
}

/** False, with the port still pinned, if one more signal is owed. */
bool InputPortInterface::unpin() {
    for (std::uint32_t now = pinned_.load(std::memory_order_relaxed);;) {
        const bool again = now == (kAgain | 1);
        // Release: our use of the port happens before its destructor continues. Acquire: the samples of the owed
        // signal. seq_cst: either a thread that waits finds that we unpinned, or mayBeOver() finds the thread.
        if (pinned_.compare_exchange_weak(now, again ? 1 : now - 1, std::memory_order_seq_cst,
                                          std::memory_order_relaxed)) {
            if (!again) Waiting::mayBeOver();  // touches no port: it may be gone
            return !again;
        }
    }
}

void InputPortInterface::finishSignals(bool executesMessages) {
    const auto unpinned = [this](unsigned pins) {
        if (pins == 0) return;
        pinned_.fetch_sub(pins);
        Waiting::mayBeOver();
    };
    unpinned(Waiting::cancel(this));
    const auto over = [this] {
        const std::uint32_t pins = pinned_.load(std::memory_order_seq_cst) & ~kAgain;
        return pins == 0 || pins <= Waiting::making(this);  // after the pins: others may take over a delivery of ours
    };
    if (over()) return;
    const Waiting here;
    for (;;) {
        const std::uint32_t seen = Waiting::now();
        unpinned(Waiting::takeOver(this));
        if (over()) return;
        here.sleep(seen, executesMessages);
    }
}

void InputPortInterface::forgetSignals() {
    finishSignals();
    (void)Waiting::abandon(this);
}

void InputPortInterface::newDataAvailable() {
    DataFlowInterface* iface = getInterface();
    if (iface && signalsInterface()) iface->dataOnPort(this);
}

}  // namespace RTT::base
