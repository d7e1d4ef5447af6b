// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How an input port tells its component of new samples.
//
// A channel signals inside the writer's Reclaimer::Guard. The component may run any code in answer (a sequential one
// runs its step), so it is told when the writer has left the guard; until then, and while it is being told, the port is
// pinned and its destructor waits. A port may be destroyed by what its own signal started, or that of another port of the
// same write: a thread does not wait for itself, and forgets what it has yet to tell of the port.
//
// A promise needs a place to be kept in. The port has one, for the thread that pins it while nobody else does. Others
// take one of the few that each thread has. If those are in use, too, whoever unpins the port last tells once more.
#include <rtt/base/InputPortInterface.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/PortEndpoint.hpp>
#include <rtt/internal/Reclaimer.hpp>
#include <rtt/internal/detail/message_pause.hpp>
#include <rtt/internal/detail/waiting.hpp>

#include <chrono>
#include <exception>
#include <thread>

namespace RTT::base {

using internal::detail::Waiting;

void InputPortInterface::signalInterface(bool on) { endpoint().setSignals(on); }

bool InputPortInterface::signalsInterface() const { return endpoint().signals(); }

void InputPortInterface::signalLater() {
    internal::DeferredCalls& calls = internal::Reclaimer::deferred();
    // seq_cst, like newDataAvailable()'s look at the interface: either finishSignals() sees this pin, or we see that the
    // port was taken out of its interface before. It also acquires the place in the port from who used it last.
    std::uint32_t before = pinned_.fetch_add(1, std::memory_order_seq_cst);
    if (calls.add((before & ~kAgain) == 0 ? &signal_ : nullptr, &InputPortInterface::deliverSignal, this)) return;
    for (std::uint32_t now = pinned_.load(std::memory_order_acquire);;) {
        if ((now & ~kAgain) == 1) {  // all others have gone meanwhile
            (void)calls.add(&signal_, &InputPortInterface::deliverSignal, this);
            return;
        }
        // Who tells once more sees our sample, because he sees this, and so the pin.
        if (pinned_.compare_exchange_weak(now, (now - 1) | kAgain, std::memory_order_acq_rel,
                                          std::memory_order_acquire))
            return;
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
        // Null: the port was destroyed meanwhile, or another thread has it.
    } while (self && !static_cast<InputPortInterface*>(self)->unpin());
}

/** False, and the port stays pinned, if one more signal is owed. */
bool InputPortInterface::unpin() {
    for (std::uint32_t now = pinned_.load(std::memory_order_relaxed);;) {
        const bool again = now == (kAgain | 1);
        // Release: all we did with the port happens before its destructor goes on. Acquire: the samples that the debt is for.
        if (pinned_.compare_exchange_weak(now, again ? 1 : now - 1, std::memory_order_acq_rel,
                                          std::memory_order_relaxed))
            return !again;
    }
}

void InputPortInterface::finishSignals(bool executesMessages) {
    if (const unsigned mine = Waiting::cancel(this)) pinned_.fetch_sub(mine, std::memory_order_release);
    const auto over = [this] {
        const std::uint32_t pins = pinned_.load(std::memory_order_seq_cst) & ~kAgain;
        return pins <= Waiting::making(this);  // after the pins: others may take from us what we are telling
    };
    if (over()) return;
    executesMessages = executesMessages && !internal::Reclaimer::inside();
    const Waiting here;
    for (;;) {
        if (const unsigned theirs = Waiting::takeOver(this)) pinned_.fetch_sub(theirs, std::memory_order_release);
        if (over()) return;
        if (executesMessages)
            internal::detail::pauseForMessages(over);
        else
            std::this_thread::sleep_for(std::chrono::microseconds(20));
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
