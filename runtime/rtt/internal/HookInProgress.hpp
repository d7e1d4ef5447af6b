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

/** Told, in the thread that executes it, of the begin and the end of each hook. */
struct HookWatch {
    void (*begin)(const HookInProgress& hook);
    /** The component may be gone: look at no more than the object's address. */
    void (*end)(const HookInProgress& hook);
};

/**
 * While one exists, this thread executes what others wrote for a component: a hook, an operation, a callback, a function.
 * They nest. For those who want to know whose code a thread is in: who reports crashes, and `deployer --rt-check`.
 * Real-time safe. Lives on the stack.
 */
class RTT_API HookInProgress {
public:
    /** A null task is the engine that executes for the process. */
    HookInProgress(const base::TaskCore* of, const char* what) noexcept;
    /** For a component that does not exist yet, or no more. Both texts outlive this object. */
    HookInProgress(const char* name, const char* what) noexcept;
    ~HookInProgress();
    HookInProgress(const HookInProgress&) = delete;
    HookInProgress& operator=(const HookInProgress&) = delete;

    /** Of this thread; null: none. May be called in a signal handler. */
    static const HookInProgress* innermost() noexcept { return top(); }
    /** Null: nobody watches, which is so at first. What it points to stays for ever. Any thread. */
    static void setWatch(const HookWatch* watch) noexcept;

    const char* const component;
    const char* const hook;            /**< "updateHook()", "configureHook()" …, "a message" … */
    const base::TaskCore* const task;  /**< null if there is none */
    const HookInProgress* const outer; /**< of this thread; null: none */

private:
    static const HookInProgress* top() noexcept;
    void enter() noexcept;
    const HookWatch* watch_ = nullptr;  // who was told of the begin
};

}  // namespace internal
}  // namespace RTT

#endif
