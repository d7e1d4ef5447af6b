// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_ENGINE_FUNCTIONS_HPP
#define ORO_INTERNAL_ENGINE_FUNCTIONS_HPP

#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/engine/function_list.hpp>

namespace RTT {
namespace base {
class ExecutableInterface;
class TaskCore;
}  // namespace base
namespace internal {

class FunctionRemoval;

/** What an ExecutionEngine executes in each step: programs, state machines and other functions. Only for the engine's
    thread. Real-time safe, except add(). */
class EngineFunctions {
public:
    typedef EngineGate::Step Step;

    /** `task` is null for an engine without a component. */
    explicit EngineFunctions(base::TaskCore* task) : task_(task) {}
    /** Unloads all. */
    ~EngineFunctions();
    EngineFunctions(const EngineFunctions&) = delete;
    EngineFunctions& operator=(const EngineFunctions&) = delete;

    void add(base::ExecutableInterface* function) { list_.add(function); }
    void remove(base::ExecutableInterface* function) { list_.remove(function); }
    /** Removes its function, and finishes the removal when that is not being executed any more. */
    void remove(FunctionRemoval& removal);

    /** Executes those that are due. Functions that are added or removed meanwhile take effect in the next step; those
        that are woken, in this one if their turn is still to come. A function may destroy this object. */
    void process(const Step& here) {
        const FunctionList::Round round = list_.begin();
        if (round.end != 0) process(here, round);
    }
    /** Executes those that others wait for, while the component itself waits. True if some have to be executed again,
        which no notification will announce. A function may destroy this object. */
    bool processAwaited(const Step& here);

private:
    void process(const Step& here, FunctionList::Round round);
    bool execute(const Step& here, base::ExecutableInterface& function) const;
    void unload(const FunctionList::Round& round, base::ExecutableInterface& function);

    base::TaskCore* const task_;
    FunctionList list_;
    base::ExecutableInterface* executing_ = nullptr;
    FunctionRemoval* removals_ = nullptr;  // of executing_
};

}  // namespace internal
}  // namespace RTT

#endif
