// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/hook_in_progress.hpp>

#include <rtt/base/TaskCore.hpp>

#include <atomic>

namespace RTT::internal {

namespace {

// Initial-exec: a signal handler reads it and must not allocate.
thread_local const HookInProgress* innermostHook __attribute__((tls_model("initial-exec"))) = nullptr;
std::atomic<const HookWatch*> hookWatch{nullptr};

// Not a virtual call: the component may be under destruction.
const char* nameOf(const base::TaskCore* task) {
    return task ? task->base::TaskCore::getName().c_str() : "GlobalEngine";
}

}  // namespace

HookInProgress::HookInProgress(const base::TaskCore* of, const char* what) noexcept
    : component(nameOf(of)), hook(what), task(of), outer(innermostHook) {
    enter();
}

HookInProgress::HookInProgress(const char* name, const char* what) noexcept
    : component(name), hook(what), task(nullptr), outer(innermostHook) {
    enter();
}

void HookInProgress::enter() noexcept {
    // A signal handler of this thread must find the object complete.
    std::atomic_signal_fence(std::memory_order_release);
    innermostHook = this;
    // Acquire: pairs with setWatch().
    watch_ = hookWatch.load(std::memory_order_acquire);
    if (watch_) watch_->begin(*this);
}

HookInProgress::~HookInProgress() {
    if (watch_) watch_->end(*this);
    innermostHook = outer;
    std::atomic_signal_fence(std::memory_order_release);
}

const HookInProgress* HookInProgress::top() noexcept { return innermostHook; }

void HookInProgress::forget(const base::TaskCore* task) noexcept {
    for (const HookInProgress* hook = innermostHook; hook; hook = hook->outer)
        if (hook->task == task) hook->component = "(destroyed)";
}

void HookInProgress::setWatch(const HookWatch* watch) noexcept { hookWatch.store(watch, std::memory_order_release); }

bool HookInProgress::replaceWatch(const HookWatch* expected, const HookWatch* watch) noexcept {
    return hookWatch.compare_exchange_strong(expected, watch);
}

}  // namespace RTT::internal
