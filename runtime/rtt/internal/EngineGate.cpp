// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/EngineGate.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/fosi.h>

#include <unistd.h>

namespace RTT {
namespace internal {

namespace {

thread_local const EngineGate::Visit* innermostVisit __attribute__((tls_model("initial-exec"))) = nullptr;

// Waiting here is rare, and for somebody who is about to leave: not worth a wake-up in the path of every sender. It sleeps,
// because that thread may have a lower priority than this one.
template <class Predicate>
void sleepUntil(const EngineGate& gate, const char* whatFor, Predicate&& predicate) {
    const EngineGate* const own = EngineGate::ofThisThread();
    const NANO_TIME begin = rtos_get_time_ns();
    bool warned = false;
    while (!predicate()) {
        if (own && own != &gate)
            own->engine()->waitForMessages(predicate, rtos_get_time_ns() + 1000000);
        else
            usleep(20);
        if (!warned && rtos_get_time_ns() - begin > 1000000000) {
            log(Warning) << "a component is being destroyed or given another activity, and waits for " << whatFor
                         << endlog();
            warned = true;
        }
    }
}

}  // namespace

thread_local const EngineGate::Step* EngineGate::Step::innermost_ = nullptr;

EngineGate::Visit::Visit(const EngineGate& gate) noexcept : gate_(gate), outer_(innermostVisit) {
    gate_.visitors_.fetch_add(1);
    innermostVisit = this;
}

EngineGate::Visit::~Visit() {
    innermostVisit = outer_;
    // Release: what we did to the engine and its activity happens before their destruction.
    gate_.visitors_.fetch_sub(1, std::memory_order_release);
    if (keeps_gate_) gate_.deref();
}

EngineGate::Step::Step(const EngineGate& gate) noexcept : gate_(&gate), outer_(innermost_), first_(!gate.isStepping()) {
    if (first_) gate.steppers_.fetch_add(1, std::memory_order_relaxed);
    innermost_ = this;
}

EngineGate::Step::~Step() {
    innermost_ = outer_;
    // Release: pairs with waitForStep().
    if (first_ && gate_) gate_->steppers_.fetch_sub(1, std::memory_order_release);
}

const EngineGate* EngineGate::ofThisThread() noexcept {
    for (const Step* step = Step::innermost_; step; step = step->outer_)
        if (step->gate_) return step->gate_;
    return nullptr;
}

bool EngineGate::isStepping() const noexcept {
    for (const Step* step = Step::innermost_; step; step = step->outer_)
        if (step->gate_ == this) return true;
    return false;
}

bool EngineGate::isSelf() const {
    if (isStepping()) return true;
    const Visit visit(*this);
    const base::ActivityInterface* const activity = visit.activity();
    return activity && activity->isSelf();
}

void EngineGate::setActivity(base::ActivityInterface* activity) {
    base::ActivityInterface* const previous = activity_.exchange(activity);
    if (previous && previous != activity) waitForVisitors();
}

void EngineGate::close() {
    engine_.store(nullptr);
    activity_.store(nullptr);
    waitForVisitors();
    // An engine may be destroyed within its own step: its visits and steps that this thread is in are told.
    for (const Visit* visit = innermostVisit; visit; visit = visit->outer_)
        if (&visit->gate_ == this && !visit->keeps_gate_) {
            visit->keeps_gate_ = true;
            ref();
        }
    for (const Step* step = Step::innermost_; step; step = step->outer_)
        if (step->gate_ == this) step->gate_ = nullptr;
}

void EngineGate::waitForVisitors() const {
    std::uint32_t own = 0;
    for (const Visit* visit = innermostVisit; visit; visit = visit->outer_)
        if (&visit->gate_ == this) ++own;
    sleepUntil(*this, "a thread that executes it or sends to it", [&] { return visitors_.load() <= own; });
}

void EngineGate::waitForStep() const {
    if (isStepping()) return;
    sleepUntil(*this, "its last step to end", [&] { return steppers_.load(std::memory_order_acquire) == 0; });
}

void EngineGate::deref() const {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

}  // namespace internal
}  // namespace RTT
