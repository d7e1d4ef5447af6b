// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/EngineGate.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/detail/futex.hpp>
#include <rtt/os/fosi.h>

#include <new>

namespace RTT {
namespace internal {

namespace {

thread_local const EngineGate::Visit* innermostVisit __attribute__((tls_model("initial-exec"))) = nullptr;

}  // namespace

thread_local const EngineGate::Step* EngineGate::Step::innermost_ = nullptr;

EngineGate::Visit::Visit(const EngineGate& gate) noexcept : gate_(gate), outer_(innermostVisit) {
    gate_.visitors_.fetch_add(1);
    innermostVisit = this;
}

EngineGate::Visit::~Visit() {
    innermostVisit = outer_;
    EngineGate::leave(gate_.visitors_);
    if (keeps_gate_) gate_.deref();
}

EngineGate::Step::Step(const EngineGate& gate) noexcept : gate_(&gate), outer_(innermost_), first_(!gate.isStepping()) {
    if (first_) gate.steppers_.fetch_add(1, std::memory_order_relaxed);
    innermost_ = this;
}

EngineGate::Step::~Step() {
    innermost_ = outer_;
    if (first_ && gate_) EngineGate::leave(gate_->steppers_);
}

bool EngineGate::Stand::enter(const EngineGate& gate, As as) {
    if (gate.isStepping()) return true;
    Visit* const visit = new (visit_) Visit(gate);
    base::ActivityInterface* const activity = visit->activity();
    const auto answer = !activity       ? base::ActivityInterface::Direct::Refused
                        : as == Anybody ? activity->beginInStead()
                                        : activity->beginDirect();
    if (answer == base::ActivityInterface::Direct::Entered)
        entered_ = activity;  // the visit keeps it
    else
        visit->~Visit();
    return answer != base::ActivityInterface::Direct::Refused;
}

void EngineGate::Stand::leave() {
    Visit* const visit = std::launder(reinterpret_cast<Visit*>(visit_));
    // Unless this thread has destroyed or exchanged it meanwhile.
    if (visit->activity() == entered_) entered_->endDirect();
    visit->~Visit();
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
    waitFor(visitors_, own, "a thread that executes it or sends to it");
}

void EngineGate::waitForStep() const {
    if (!isStepping()) waitFor(steppers_, 0, "its last step to end");
}

// Release: what was done to the engine and its activity happens before the end of the wait. Who waits adds itself to the same
// word first, so either that comes before and is seen here, or the waiter finds the smaller number. The gate may be
// gone after the subtraction; the kernel looks at the address only.
void EngineGate::leave(Count& count) noexcept {
    if (count.fetch_sub(1, std::memory_order_release) >= kWaiter) os::detail::futexWakeAll(count);
}

void EngineGate::waitFor(Count& count, std::uint32_t own, const char* what) const {
    const auto over = [&] { return (count.load() & (kWaiter - 1)) <= own; };
    if (over()) return;
    count.fetch_add(kWaiter);
    const EngineGate* const executing = ofThisThread();
    NANO_TIME warning = os::detail::after(rtos_get_time_ns(), 1000000000);
    for (std::uint32_t now = count; (now & (kWaiter - 1)) > own; now = count) {
        if (executing && executing != this)
            executing->engine()->waitForMessages(over, warning, &count);
        else
            os::detail::futexWait(count, now, warning);
        if (warning == os::detail::kForever || rtos_get_time_ns() < warning) continue;
        log(Warning) << "a component is being destroyed or given another activity, and waits for " << what << endlog();
        warning = os::detail::kForever;
    }
    count.fetch_sub(kWaiter);
}

void EngineGate::deref() const {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

}  // namespace internal
}  // namespace RTT
