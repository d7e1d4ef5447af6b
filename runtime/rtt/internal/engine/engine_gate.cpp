// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/engine_gate.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/internal/engine/other_order.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/futex.hpp>

#include <algorithm>
#include <new>

namespace RTT::internal {

thread_local const EngineGate::Step* EngineGate::Step::innermost_ = nullptr;

EngineGate::Step::Step(const EngineGate& gate) noexcept
    : gate_(&gate), outer_(innermost_), place_(gate.isStepping() ? nullptr : &Presence::enter(gate.step())) {
    innermost_ = this;
}

EngineGate::Step::~Step() {
    innermost_ = outer_;
    if (place_) Presence::leave(*place_);
}

void EngineGate::Step::fail() const {
    if (!gone()) engine()->enterException();
}

void EngineGate::sleepOn(const Presence::Word& word, std::uint32_t seen, std::int64_t deadline) {
    const EngineGate* const gate = ofThisThread();
    if (gate && gate->engine())
        gate->engine()->waitForMessages([&] { return word != seen; }, deadline, &word);
    else if (!OtherOrder::executedHere())
        os::detail::futexWait(word, seen, OtherOrder::limit(deadline));
}

bool EngineGate::Stand::enter(const EngineGate& gate, As as) {
    if (gate.isStepping()) return true;
    // A retired engine executes nothing more.
    if (as == Self && gate.retired()) return gate.offeredToRetirer() != nullptr;
    Visit* const visit = new (visit_) Visit(gate);
    base::ActivityInterface* const activity = visit->activity();
    const auto answer = !activity         ? base::ActivityInterface::Direct::Refused
                        : as == Anybody   ? activity->beginInStead()
                        : visit->engine() ? activity->beginDirect()
                                          : base::ActivityInterface::Direct::Refused;
    if (answer == base::ActivityInterface::Direct::Entered)
        entered_ = activity, gate_ = &gate;  // the visit keeps both
    else
        visit->~Visit();
    return answer != base::ActivityInterface::Direct::Refused;
}

void EngineGate::Stand::leave() {
    Visit* const visit = std::launder(reinterpret_cast<Visit*>(visit_));
    // This thread may have destroyed or exchanged the activity meanwhile.
    if (visit->activity() == entered_)
        entered_->endDirect();
    else
        Presence::leaveDownTo(gate_);
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

ExecutionEngine* EngineGate::offeredToRetirer() const {
    return retirer_ == os::detail::currentTid() ? engine_.load() : nullptr;
}

void EngineGate::retire() {
    retirer_ = os::detail::currentTid();
    offered_ = nullptr;
}

bool EngineGate::waitUntilLeft(std::int64_t deadline) {
    if (left_) return true;
    if (!waitFor(this, "a thread that executes it or sends to it", deadline)) return false;
    if (!isStepping() && !waitFor(step(), "its last step to end", deadline)) return false;
    left_ = true;
    return true;
}

void EngineGate::close() {
    offered_.store(nullptr);
    engine_.store(nullptr);
    activity_.store(nullptr);
    waitForVisitors();
    // An engine may be destroyed within its own step, and this thread then continues to use the gate.
    for (unsigned visits = Presence::keep(this); visits; --visits) ref();
    for (const Step* step = Step::innermost_; step; step = step->outer_)
        if (step->gate_ == this) step->gate_ = nullptr;
    Presence::forget(step());
}

void EngineGate::waitForVisitors() const { (void)waitFor(this, "a thread that executes it or sends to it"); }

void EngineGate::waitForStep() const {
    if (!isStepping()) (void)waitFor(step(), "its last step to end");
}

bool EngineGate::waitFor(const void* use, const char* what, std::int64_t deadline) const {
    const Presence::Waiter waiter(use);
    const auto over = [&] { return !waiter.others(); };
    const EngineGate* const executing = ofThisThread();
    NANO_TIME warning = os::detail::after(rtos_get_time_ns(), 1000000000);
    for (;;) {
        const std::uint32_t seen = waiter.word();
        if (over()) return true;
        if (executing && executing != this)
            executing->engine()->waitForMessages(over, std::min<std::int64_t>(warning, deadline), &waiter.word());
        else
            os::detail::futexWait(waiter.word(), seen, std::min<std::int64_t>(warning, deadline));
        if (deadline != os::detail::kForever && rtos_get_time_ns() >= deadline) return over();
        if (warning == os::detail::kForever || rtos_get_time_ns() < warning) continue;
        log(Warning) << "a component is being destroyed or given another activity, and waits for " << what << endlog();
        warning = os::detail::kForever;
    }
}

void EngineGate::deref() const {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

}  // namespace RTT::internal
