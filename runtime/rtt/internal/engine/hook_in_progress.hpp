// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_HOOK_IN_PROGRESS_HPP
#define ORO_INTERNAL_HOOK_IN_PROGRESS_HPP

#include <rtt/rtt-config.h>

namespace RTT {
namespace base {
class TaskCore;
}
namespace internal {

class HookInProgress;

/** Called before and after each hook, in the thread that executes it. */
struct HookWatch {
    void (*begin)(const HookInProgress& hook);
    /** The component may be gone: use no more than the object's address. */
    void (*end)(const HookInProgress& hook);
};

/**
 * While one exists, this thread executes user code of a component: a hook, an operation, a callback, a function. They
 * nest. The log, crash reports and `deployer --rt-check` use it to name that code. Real-time safe. Lives on the stack.
 */
class RTT_API HookInProgress {
public:
    /** A null task is the GlobalEngine. */
    HookInProgress(const base::TaskCore* of, const char* what) noexcept;
    /** For a component that does not exist yet, or no longer exists. Both texts outlive this object. */
    HookInProgress(const char* name, const char* what) noexcept;
    ~HookInProgress();
    HookInProgress(const HookInProgress&) = delete;
    HookInProgress& operator=(const HookInProgress&) = delete;

    /** Of this thread; null if there is none. May be called in a signal handler. */
    static const HookInProgress* innermost() noexcept { return top(); }
    /** Null, as at first, for no watch. `watch` is never destroyed. Any thread. */
    static void setWatch(const HookWatch* watch) noexcept;
    /** The same, but only if the present watch is `expected`; false otherwise. */
    static bool replaceWatch(const HookWatch* expected, const HookWatch* watch) noexcept;
    /** For the destructor of a component, whose name is about to go: code of this thread that is still within one of
        its hooks has the name "(destroyed)" from now on. */
    static void forget(const base::TaskCore* task) noexcept;

    mutable const char* component;     /**< mutable for forget() */
    const char* const hook;            /**< "updateHook()", "configureHook()" …, "a message" … */
    const base::TaskCore* const task;  /**< null if there is none */
    const HookInProgress* const outer; /**< of this thread; null if there is none */

private:
    static const HookInProgress* top() noexcept;
    void enter() noexcept;
    const HookWatch* watch_ = nullptr;  // the one whose begin() was called
};

}  // namespace internal
}  // namespace RTT

#endif
