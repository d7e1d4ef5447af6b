// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Passes calls of operations to a state machine.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_EVENT_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_EVENT_HPP

#include <rtt/Handle.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/scripting/detail/machine/machine_code.hpp>

#include <boost/weak_ptr.hpp>

#include <array>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

namespace RTT::scripting::detail {

class EventQueue;

/** Calls of one operation. */
class OperationEvent final : public MachineEvent {
public:
    typedef base::DataSourceBase::shared_ptr Source;
    static constexpr unsigned kMostWaiting = 16;

    /** A call that waits for the machine, with its arguments. */
    struct Call {
        OperationEvent* event = nullptr;
        std::vector<Source> arguments;
        std::atomic<bool> waits{false};
        Call* next = nullptr;
    };

    /** `arguments` store those of a call; `assign` copies them to variables of the script. */
    OperationEvent(std::vector<Source> arguments, std::vector<ActionPtr> assign);
    void receive() override;
    /** Makes calls events of the machine, as long as this exists. */
    void listenTo(internal::SignalBase& signal, std::shared_ptr<EventQueue> queue);

    /** Copies a call; null if too many wait. Any thread; real-time safe if copying the arguments is. */
    Call* keep(void* const* arguments);
    /** Stores the arguments before receive(). The caller must have the machine. */
    void hold(void* const* arguments);
    void hold(Call& kept);

private:
    const std::vector<Source> arguments_;
    const std::vector<ActionPtr> assign_;
    std::array<Call, kMostWaiting> calls_;
    std::unique_ptr<CleanupHandle> handle_;
};

/**
 * The calls that a machine has not taken yet, in order. Calls in its component's thread are taken at once, unless
 * another thread has the machine; others wait for a message or the next cycle. Neither allocates nor locks.
 */
class EventQueue final : public base::DisposableInterface, public std::enable_shared_from_this<EventQueue> {
public:
    explicit EventQueue(boost::intrusive_ptr<const internal::EngineGate> gate) : gate_(std::move(gate)) {}

    /** Sets the machine, before the first call. */
    void leadTo(const StateMachinePtr& machine) { machine_ = machine; }
    /** `event` belongs to the machine. Any thread. */
    void called(OperationEvent& event, void* const* arguments);

    // -- The machine -----------------------------------------------------------------------------------------
    bool empty() const { return !last_.load(); }
    /** Calls `take(event)` for each waiting call. The caller must have the machine. */
    template <class Take>
    void takeAll(Take take) {
        OperationEvent::Call* call = takeList();
        while (call) {
            OperationEvent::Call& taken = *call;
            call = call->next;
            taken.event->hold(taken);
            take(*taken.event);
        }
    }
    /** The number of calls dropped since the last time, because too many were waiting. */
    unsigned takeLost() { return lost_.load(std::memory_order_relaxed) ? lost_.exchange(0) : 0; }

    // For the engine.
    void executeAndDispose() override;
    void dispose() override;

private:
    OperationEvent::Call* takeList();
    void ask();

    const boost::intrusive_ptr<const internal::EngineGate> gate_;
    boost::weak_ptr<StateMachine> machine_;
    std::atomic<OperationEvent::Call*> last_{nullptr};  // each refers to the previous one
    std::atomic<unsigned> lost_{0};
    std::atomic<bool> asked_{false};    // the engine has the message
    std::shared_ptr<EventQueue> self_;  // keeps this meanwhile
};

}  // namespace RTT::scripting::detail

#endif
