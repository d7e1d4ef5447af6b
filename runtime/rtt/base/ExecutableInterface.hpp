// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXECUTABLE_INTERFACE_HPP
#define ORO_EXECUTABLE_INTERFACE_HPP

#include <rtt/rtt-config.h>

#include <atomic>

namespace RTT {
class ExecutionEngine;
namespace base {

/** A function that an ExecutionEngine executes once per step until it is done: programs, state machines. */
class RTT_API ExecutableInterface {
public:
    virtual ~ExecutableInterface();
    /** One step, in the engine's thread; false when done. Must be real-time safe if the component is. */
    virtual bool execute() = 0;
    /** True for a function that other threads wait for. It is also executed while the component waits for another one,
        which may be waiting for it, even within an execute() that waits. Only the engine's own thread may remove it. */
    virtual bool isAwaited() const { return false; }
    /** True if execute() would do nothing: the engine leaves the function out until wake(). It asks after each
        execute() and each wake(), in its own thread. Real-time safe; calls nothing of the engine. */
    virtual bool isIdle() const { return false; }
    /** True for a function that is not executed in Exception, such as programs and state machines. */
    virtual bool pausesInException() const { return false; }
    /** Called when an engine takes the function. */
    virtual void loaded(ExecutionEngine* engine) { engine_ = engine; }
    /** Called when the engine has released the function. */
    virtual void unloaded() { engine_ = nullptr; }
    /** Any thread. A function that removes itself is unloaded before its execute() returns. */
    bool isLoaded() const { return engine_ != nullptr; }
    ExecutionEngine* getEngine() const { return engine_; }

protected:
    /** Call it after a change that makes isIdle() false. It wakes no activity: the function is executed by the next
        step of the engine that executes functions, or by the rest of the current one. Any thread; real-time safe. */
    void wake() const noexcept;

private:
    std::atomic<ExecutionEngine*> engine_{nullptr};
};

}  // namespace base
}  // namespace RTT

#endif
