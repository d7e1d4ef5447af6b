// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_ENGINE_REMOVAL_HPP
#define ORO_INTERNAL_DETAIL_ENGINE_REMOVAL_HPP

#include <rtt/ExecutionEngine.hpp>

namespace RTT {

/** Asks the thread of an engine to remove a function. Lives on the stack of the thread that waits for the removal. */
class ExecutionEngine::Removal {
public:
    enum State { Waiting, Removed, Disposed };

    /** The thread waits at the wait point of `waiting`. */
    Removal(base::ExecutableInterface* what, const internal::EngineGate& waiting)
        : function(what), waiting_(&waiting) {}
    Removal(const Removal&) = delete;
    Removal& operator=(const Removal&) = delete;

    State state() const { return state_.load(); }
    void finish(State state) {
        const boost::intrusive_ptr<const internal::EngineGate> waiting =
            waiting_;  // `this` is gone once the state is seen
        state_.store(state);
        waiting->waitPoint.notify();
    }

    base::ExecutableInterface* const function;
    Removal* next = nullptr;  // used by the engine's thread

private:
    const boost::intrusive_ptr<const internal::EngineGate> waiting_;
    std::atomic<State> state_{Waiting};
};

}  // namespace RTT

#endif
