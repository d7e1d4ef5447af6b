// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_ENGINE_REMOVAL_HPP
#define ORO_INTERNAL_DETAIL_ENGINE_REMOVAL_HPP

#include <rtt/ExecutionEngine.hpp>

namespace RTT {

/** Asks the thread of an engine to take a function out. Lives on the stack of the thread that waits for it. */
class ExecutionEngine::Removal {
public:
    enum State { Waiting, Removed, Disposed };

    /** `waiting` is where that thread waits. */
    Removal(base::ExecutableInterface* what, const internal::EngineGate& waiting)
        : function(what), waiting_(&waiting) {}
    Removal(const Removal&) = delete;
    Removal& operator=(const Removal&) = delete;

    State state() const { return state_.load(); }
    void finish(State state) {
        const boost::intrusive_ptr<const internal::EngineGate> waiting =
            waiting_;  // `this` is gone as soon as that is seen
        state_.store(state);
        waiting->waitPoint.notify();
    }

    base::ExecutableInterface* const function;
    Removal* next = nullptr;  // in the engine's thread

private:
    const boost::intrusive_ptr<const internal::EngineGate> waiting_;
    std::atomic<State> state_{Waiting};
};

}  // namespace RTT

#endif
