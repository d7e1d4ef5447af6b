// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_FUNCTION_REMOVAL_HPP
#define ORO_INTERNAL_DETAIL_FUNCTION_REMOVAL_HPP

#include <rtt/internal/engine/engine_gate.hpp>

#include <atomic>

namespace RTT {
namespace base {
class ExecutableInterface;
}
namespace internal {

/** Asks the thread of an engine to remove a function. Lives on the stack of the thread that waits for the removal. */
class FunctionRemoval {
public:
    enum State { Waiting, Removed, Disposed };

    /** The thread waits at the wait point of `waiting`. */
    FunctionRemoval(base::ExecutableInterface* what, const EngineGate& waiting) : function(what), waiting_(&waiting) {}
    FunctionRemoval(const FunctionRemoval&) = delete;
    FunctionRemoval& operator=(const FunctionRemoval&) = delete;

    State state() const { return state_.load(); }
    void finish(State state) {
        const boost::intrusive_ptr<const EngineGate> waiting = waiting_;  // `this` is gone once the state is seen
        state_.store(state);
        waiting->waitPoint.notify();
    }

    base::ExecutableInterface* const function;
    FunctionRemoval* next = nullptr;  // used by the engine's thread

private:
    const boost::intrusive_ptr<const EngineGate> waiting_;
    std::atomic<State> state_{Waiting};
};

}  // namespace internal
}  // namespace RTT

#endif
