// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How other threads ask an engine for something, and how its own thread waits for others.
#include <rtt/ExecutionEngine.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/detail/engine_removal.hpp>
#include <rtt/internal/detail/engine_sleep.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>

namespace RTT {

using internal::EngineGate;
using internal::Mailbox;

namespace {
constexpr std::int64_t kForever = INT64_MAX;
constexpr std::int64_t kMillisecond = 1000000;

/** A moment from now, for somebody who waits for two things and can sleep for one of them only. */
std::int64_t soon(std::int64_t ms) { return rtos_get_time_ns() + ms * kMillisecond; }
}  // namespace

void ExecutionEngine::dispose(Mailbox::Item item) {
    if (!item.what) return;
    switch (item.kind) {
        case Mailbox::Kind::Message: static_cast<base::DisposableInterface*>(item.what)->dispose(); break;
        case Mailbox::Kind::Port: break;
        case Mailbox::Kind::AddFunction: static_cast<base::ExecutableInterface*>(item.what)->unloaded(); break;
        case Mailbox::Kind::RemoveFunction: static_cast<Removal*>(item.what)->finish(Removal::Disposed); break;
    }
}

void ExecutionEngine::disposeQueued() {
    Mailbox::Item item;
    while (mailbox_.take(item)) dispose(item);
}

// The component may enter FatalError between our look at its state and put(). Its thread then enters the new state,
// notifies and disposes of what is queued, in this order; we put, notify and look at the state again. Both change one
// word, so one of the two comes second and sees what the other did before: the message is disposed of.
bool ExecutionEngine::accepts() const { return !(task_ && task_->base::TaskCore::inFatalError()); }

// In a visit to the gate, so that neither the engine nor its activity go away.
bool ExecutionEngine::enqueue(Mailbox::Item item, base::ActivityInterface* activity) {
    if (!item.what || !activity || gate_->retired() || !accepts()) return false;
    if (!mailbox_.put(item)) {
        if (item.kind != Mailbox::Kind::Port) return false;
        // An exchange, so that who takes the flag away sees what all those have done who set it.
        missed_ports_.exchange(true);
    }
    // The engine's thread may be inside waitForMessages(). It does not need to know of ports there.
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
        Removal removal(function, waiting);
        awaitRemoval(removal, waiting);
        if (removal.state() == Removal::Disposed) {
            // Nobody executes any more, at most what is left of the last step. Other threads may remove as well.
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

// Takes the function out in this thread, if this is the component's thread or if nobody executes the component. A `removal` that is
// queued is withdrawn first; false if it cannot be, because the engine has taken it.
bool ExecutionEngine::removeHere(base::ExecutableInterface* function, Removal* removal) {
    const EngineGate::Stand stand(gate_.get(), EngineGate::Stand::Anybody);
    if (!stand || (removal && !mailbox_.withdraw({Mailbox::Kind::RemoveFunction, removal}))) return false;
    takeAdditions();
    mailbox_.withdraw({Mailbox::Kind::AddFunction, function});
    functions_.remove(function);
    return true;
}

// While nobody executes the component nobody empties its queue, and functions that are added and removed would fill it. Called by
// the thread that may touch the component.
void ExecutionEngine::takeAdditions() {
    Mailbox::Item item;
    const auto isWithdrawn = [&] { return !item.what && item.kind == Mailbox::Kind::RemoveFunction; };
    while (mailbox_.peek(item) && (item.kind == Mailbox::Kind::AddFunction || isWithdrawn()) && mailbox_.take(item)) {
        if (item.kind != Mailbox::Kind::AddFunction)
            dispose(item);  // after a fatal error, when another thread clears the queue at this moment
        else if (item.what)
            functions_.add(static_cast<base::ExecutableInterface*>(item.what));
    }
}

// The thread of a component goes on executing its messages: the function may be waiting for one of them.
void ExecutionEngine::awaitRemoval(Removal& removal, const EngineGate& waiting) {
    const auto finished = [&] { return removal.state() != Removal::Waiting; };
    // The queue is in order, so an addition that still waits in it is executed before the removal. It may be full.
    bool queued = false;
    // Looks at once, and then from time to time, because an activity that is stopped meanwhile tells nobody, nor does a
    // thread that executes it no more.
    do {
        if (!queued) queued = enqueue({Mailbox::Kind::RemoveFunction, &removal});
        if (removeHere(removal.function, queued ? &removal : nullptr)) return removal.finish(Removal::Removed);
        const EngineGate::Visit visit(*gate_);
        const bool executed = !gate_->retired() && visit.activity() && visit.activity()->isActive() && accepts();
        if (!executed && (!queued || mailbox_.withdraw({Mailbox::Kind::RemoveFunction, &removal}))) {
            removal.finish(Removal::Disposed);
            return;
        }
    } while (!waiting.engine()->waitForMessages(finished, soon(queued ? 20 : 1)));
}

// Executes the messages of all engines that this thread is executing, and the functions that others wait for. True if some of
// those have to be executed again soon.
bool ExecutionEngine::processWaiting() {
    bool again = false;
    for (const Step* step = Step::innermost(); step; step = step->outer()) {
        ExecutionEngine* const engine = step->engine();
        if (!engine) continue;
        const Step here(*engine->gate_);
        engine->processMailbox(here, Depth::Waiting);
        if (!here.gone()) again = engine->processAwaited(here) || again;
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
        sleep.until(again ? std::min(deadline, soon(1)) : deadline);
    }
    // The trigger that came with a port may have been used up before we waited.
    for (const Step* step = &here; step; step = step->outer())
        if (ExecutionEngine* const engine = step->engine()) engine->triggerDeferred();
    return true;
}

// False if this thread must leave the component alone. `again` as processWaiting().
bool ExecutionEngine::processInStead(bool& again) {
    const EngineGate::Stand stand(gate_.get());
    if (!stand) return false;
    const Step here(*gate_);
    again = processWaiting();
    return true;
}

// By a thread that stands for the activity and is not within a step: another one may execute the component at any moment.
bool ExecutionEngine::waitInStead(const boost::function<bool()>& done, std::int64_t deadline) {
    internal::detail::EngineSleep sleep(*gate_);
    while (!done()) {
        sleep.look();
        bool again = false;
        const bool mine = processInStead(again);
        if (done()) break;
        if (mine && !mailbox_.empty()) continue;
        if (deadline != kForever && rtos_get_time_ns() >= deadline) return false;
        // Who executes it now may leave something to this thread, and tells nobody.
        sleep.until(mine && !again ? deadline : std::min(deadline, soon(1)));
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
        gate_->waitPoint.wait(ticket, deadline);
        if (deadline != kForever && rtos_get_time_ns() >= deadline) return done();
    }
    return true;
}

void ExecutionEngine::waitForMessages(const boost::function<bool()>& done) { waitForMessages(done, kForever); }

void ExecutionEngine::triggerDeferred() {
    if (deferred_ || missed_ports_) triggerSelf();
}

void ExecutionEngine::triggerSelf() {
    const EngineGate::Visit visit(*gate_);
    if (visit.activity()) visit.activity()->trigger();
}

bool ExecutionEngine::isSelf() const { return gate_->isSelf(); }
bool ExecutionEngine::isStepping() const { return gate_->isStepping(); }

}  // namespace RTT
