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
    /** True for one that others wait for. It is executed also while the component waits for somebody else, who may be waiting
        for this one in turn; also within an execute() that waits. Only the engine's own thread may remove it. */
    virtual bool isAwaited() const { return false; }
    /** True for one whose execute() would do nothing: the engine leaves it out until wake() was called. It asks after each
        execute() and each wake(), in its own thread. Real-time safe; calls nothing of the engine. */
    virtual bool isIdle() const { return false; }
    /** True for one that is not executed while its component is in Exception, as programs and state machines. */
    virtual bool pausesInException() const { return false; }
    /** The engine takes this on. */
    virtual void loaded(ExecutionEngine* engine) { engine_ = engine; }
    /** The engine is finished with this. */
    virtual void unloaded() { engine_ = nullptr; }
    /** Any thread. A function that removes itself is unloaded before its execute() returns. */
    bool isLoaded() const { return engine_ != nullptr; }
    ExecutionEngine* getEngine() const { return engine_; }

protected:
    /** To be called after something was done that makes isIdle() false. It wakes no activity: the next step of the engine that
        executes functions executes this one, also the rest of a step that goes on. Any thread; real-time safe. */
    void wake() const noexcept;

private:
    std::atomic<ExecutionEngine*> engine_{nullptr};
};

}  // namespace base
}  // namespace RTT

#endif
