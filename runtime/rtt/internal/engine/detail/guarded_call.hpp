// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_GUARDED_CALL_HPP
#define ORO_INTERNAL_DETAIL_GUARDED_CALL_HPP

#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>

#include <exception>
#include <string>

namespace RTT {
namespace internal {
namespace detail {

/** The name of the component in messages. */
std::string nameOf(const base::TaskCore* task);
/** Reports that `what` threw, and puts the component into Exception, unless it was destroyed. Separate, so that a
    normal step does not prepare for it. */
[[gnu::cold, gnu::noinline]] void threw(const EngineGate::Step& here, const base::TaskCore* task, const char* what,
                                        const char* why);

/** Calls user code within a step. False if that threw; the component is then in Exception. `task` may be null. */
template <class Action>
bool guarded(const EngineGate::Step& here, base::TaskCore* task, const char* what, Action&& action) {
    try {
        const HookInProgress hook(task, what);
        action();
        return true;
    } catch (const std::exception& e) {
        threw(here, task, what, e.what());
    } catch (...) {
        threw(here, task, what, "something that is no std::exception");
    }
    return false;
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
