// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How an engine takes requests of other threads, and how its own thread waits for others.
#include <rtt/ExecutionEngine.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/detail/engine_sleep.hpp>
#include <rtt/internal/engine/detail/function_removal.hpp>
#include <rtt/internal/engine/other_order.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>

namespace RTT {

using internal::EngineGate;
using internal::FunctionRemoval;
using internal::Mailbox;
using internal::OtherOrder;

namespace {
constexpr std::int64_t kForever = INT64_MAX;
constexpr std::int64_t kMillisecond = 1000000;

/** A deadline soon, for a thread that waits for two events and can sleep for only one of them. */
std::int64_t soon(std::int64_t ms) { return rtos_get_time_ns() + ms * kMillisecond; }
}  // namespace

void ExecutionEngine::dispose(Mailbox::Item item) {
    if (!item.what) return;
    switch (item.kind) {
        case Mailbox::Kind::Message: static_cast<base::DisposableInterface*>(item.what)->dispose(); break;
        case Mailbox::Kind::Port: break;
        case Mailbox::Kind::AddFunction: static_cast<base::ExecutableInterface*>(item.what)->unloaded(); break;
        case Mailbox::Kind::RemoveFunction:
            static_cast<FunctionRemoval*>(item.what)->finish(FunctionRemoval::Disposed);
            break;
    }
}

void ExecutionEngine::disposeQueued() {
    Mailbox::Item item;
    while (mailbox_.take(item)) dispose(item);
}

// The component may enter FatalError between our look at its state and put(). Its thread then enters the new state,
// notifies and disposes of the queue, in this order; we put, notify and look at the state again. Both change one word,
// so one of the two comes second and sees what the other did before: the message is disposed of.
bool ExecutionEngine::accepts() const { return !(task_ && task_->base::TaskCore::inFatalError()); }

// Call it in a visit to the gate, so that neither the engine nor its activity goes away.
bool ExecutionEngine::enqueue(Mailbox::Item item, base::ActivityInterface* activity) {
    if (!item.what || !activity || gate_->retired() || !accepts()) return false;
    if (!mailbox_.put(item)) {
        if (item.kind != Mailbox::Kind::Port) return false;
        ports_.miss();
    }
    // The engine's thread may be inside waitForMessages(), where it need not learn of ports.
    if (item.kind == Mailbox::Kind::Port)
        gate_->waitPoint.mark();
    else
        gate_->waitPoint.notify();
    if (!accepts() || gate_->retired()) {
        disposeQueued();
        return true;
    }
    activity->trigger();
    return true;
}

bool ExecutionEngine::enqueue(Mailbox::Item item) {
    const EngineGate::Visit visit(*gate_);
    return enqueue(item, visit.activity());
}

bool ExecutionEngine::process(const EngineGate& gate, base::DisposableInterface* message) {
    const EngineGate::Visit visit(gate);
    ExecutionEngine* const engine = visit.engine();
    return engine && engine->enqueue({Mailbox::Kind::Message, message}, visit.activity());
}

bool ExecutionEngine::process(base::DisposableInterface* message) { return enqueue({Mailbox::Kind::Message, message}); }

bool ExecutionEngine::process(base::PortInterface* port) { return enqueue({Mailbox::Kind::Port, port}); }

bool ExecutionEngine::runFunction(base::ExecutableInterface* function) {
    if (!function || function->isLoaded() || !getActivity() || !accepts()) return false;
    function->loaded(this);
    if (enqueue({Mailbox::Kind::AddFunction, function})) return true;
    function->unloaded();
    return false;
}

bool ExecutionEngine::removeFunction(base::ExecutableInterface* function) {
    if (!function || !function->isLoaded() || function->getEngine() != this) return true;
    if (!removeHere(function)) {
        const EngineGate* const own = EngineGate::ofThisThread();
        const EngineGate& waiting = own ? *own : *gate_;
        FunctionRemoval removal(function, waiting);
        awaitRemoval(removal, waiting);
        if (removal.state() == FunctionRemoval::Disposed) {
            // No thread executes the engine now, except the rest of the last step. Other threads may remove as well.
            gate_->waitForStep();
            static os::Mutex removers;
            const os::MutexLock lock(removers);
            mailbox_.withdraw({Mailbox::Kind::AddFunction, function});
            functions_.remove(function);
        }
    }
    function->unloaded();
    return true;
}

// Removes the function in this thread, if that is the component's or if no thread executes the component. Withdraws a
// queued `removal` first; false if the engine has taken it.
bool ExecutionEngine::removeHere(base::ExecutableInterface* function, FunctionRemoval* removal) {
    const EngineGate::Stand stand(gate_.get(), EngineGate::Stand::Anybody);
    if (!stand || (removal && !mailbox_.withdraw({Mailbox::Kind::RemoveFunction, removal}))) return false;
    takeAdditions();
    mailbox_.withdraw({Mailbox::Kind::AddFunction, function});
    functions_.remove(function);
    return true;
}

// While no thread executes the component none empties its queue, and functions that are added and removed would fill
// it. For the thread that may touch the component.
void ExecutionEngine::takeAdditions() {
    Mailbox::Item item;
    const auto isWithdrawn = [&] { return !item.what && item.kind == Mailbox::Kind::RemoveFunction; };
    while (mailbox_.peek(item) && (item.kind == Mailbox::Kind::AddFunction || isWithdrawn()) && mailbox_.take(item)) {
        if (item.kind != Mailbox::Kind::AddFunction)
            dispose(item);  // after a fatal error, while another thread clears the queue
        else if (item.what)
            functions_.add(static_cast<base::ExecutableInterface*>(item.what));
    }
}

// A component's thread executes its messages meanwhile, because the function may be waiting for one of them.
void ExecutionEngine::awaitRemoval(FunctionRemoval& removal, const EngineGate& waiting) {
    const auto finished = [&] { return removal.state() != FunctionRemoval::Waiting; };
    // The queue keeps the order, so a queued addition is executed before the removal. The queue may be full.
    bool queued = false;
    // Looks at once, and then from time to time, because neither an activity that stops meanwhile nor a thread that no
    // longer executes it notifies.
    do {
        if (!queued) queued = enqueue({Mailbox::Kind::RemoveFunction, &removal});
        if (removeHere(removal.function, queued ? &removal : nullptr)) return removal.finish(FunctionRemoval::Removed);
        const EngineGate::Visit visit(*gate_);
        const bool executed = !gate_->retired() && visit.activity() && visit.activity()->isActive() && accepts();
        if (!executed && (!queued || mailbox_.withdraw({Mailbox::Kind::RemoveFunction, &removal}))) {
            removal.finish(FunctionRemoval::Disposed);
            return;
        }
    } while (!waiting.engine()->waitForMessages(finished, soon(queued ? 20 : 1)));
}

// Executes the messages of all engines that this thread is executing, and functions that others wait for. True if some
// of these functions have to be executed again soon.
bool ExecutionEngine::processWaiting() {
    bool again = false;
    for (const Step* step = Step::innermost(); step; step = step->outer()) {
        ExecutionEngine* const engine = step->engine();
        if (!engine) continue;
        const Step here(*engine->gate_);
        engine->processMailbox(here, Depth::Waiting);
        if (!here.gone()) again = engine->functions_.processAwaited(here) || again;
    }
    return again;
}

bool ExecutionEngine::waitForMessages(const boost::function<bool()>& done, std::int64_t deadline,
                                      const internal::Presence::Word* also) {
    const Step here(*gate_);
    internal::detail::EngineSleep sleep(*gate_, also);
    while (!done()) {
        sleep.look();
        const bool again = processWaiting();
        if (done()) break;
        if (!mailbox_.empty()) continue;
        if (deadline != kForever && rtos_get_time_ns() >= deadline) return false;
        if (OtherOrder::executedHere()) continue;
        sleep.until(again ? std::min(deadline, soon(1)) : OtherOrder::limit(deadline));
    }
    // The trigger of a port may have been used up before we waited.
    for (const Step* step = &here; step; step = step->outer())
        if (ExecutionEngine* const engine = step->engine()) engine->triggerDeferred();
    return true;
}

// False if this thread must not touch the component. `again` is the result of processWaiting().
bool ExecutionEngine::processInStead(bool& again) {
    const EngineGate::Stand stand(gate_.get());
    if (!stand) return false;
    const Step here(*gate_);
    again = processWaiting();
    return true;
}

// For a thread that acts as the activity outside a step: another one may execute the component at any moment.
bool ExecutionEngine::waitInStead(const boost::function<bool()>& done, std::int64_t deadline) {
    internal::detail::EngineSleep sleep(*gate_);
    while (!done()) {
        sleep.look();
        bool again = false;
        const bool mine = processInStead(again);
        if (done()) break;
        if (mine && !mailbox_.empty()) continue;
        if (deadline != kForever && rtos_get_time_ns() >= deadline) return false;
        if (OtherOrder::executedHere()) continue;
        // A thread that executes it now may leave work to this thread without a notification.
        sleep.until(mine && !again ? OtherOrder::limit(deadline) : std::min(deadline, soon(1)));
    }
    triggerDeferred();
    return true;
}

bool ExecutionEngine::waitForMessages(const boost::function<bool()>& done, std::int64_t deadline) {
    if (isStepping()) return waitForMessages(done, deadline, nullptr);
    if (isSelf()) return waitInStead(done, deadline);
    while (!done()) {
        const std::uint32_t ticket = gate_->waitPoint.ticket();
        if (done()) return true;
        if (OtherOrder::executedHere()) continue;
        gate_->waitPoint.wait(ticket, OtherOrder::limit(deadline));
        if (deadline != kForever && rtos_get_time_ns() >= deadline) return done();
    }
    return true;
}

void ExecutionEngine::waitForMessages(const boost::function<bool()>& done) { waitForMessages(done, kForever); }

void ExecutionEngine::triggerDeferred() {
    if (ports_.any()) triggerSelf();
}

void ExecutionEngine::triggerSelf() {
    const EngineGate::Visit visit(*gate_);
    if (visit.activity()) visit.activity()->trigger();
}

bool ExecutionEngine::isSelf() const { return gate_->isSelf(); }
bool ExecutionEngine::isStepping() const { return gate_->isStepping(); }

}  // namespace RTT
