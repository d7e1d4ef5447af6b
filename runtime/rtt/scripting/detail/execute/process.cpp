// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/execute/process.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/engine/interruption.hpp>
#include <rtt/internal/calls/sending.hpp>
#include <rtt/types/refusal_watch.hpp>

#include <diag/print.hpp>

#include <exception>
#include <utility>

namespace RTT::scripting::detail {

namespace {

constexpr unsigned kMostYields = 10000;  // in runToEnd()

}  // namespace

Process::Process(const Code& code) : code_(code), next_(code.begin()) {}

const Code& Process::codeOf(const Activation* function) const { return function ? function->code : code_; }

template <class Until>
Process::Outcome Process::execute(Until until) {
    if (failed_) return Outcome::Failed;
    started_ = true;
    if (const std::string* const lost = peers_ ? peers_->lost() : nullptr) {
        at_ = next_;
        loseSight(*lost);
        return outcome_;
    }
    rounds_ = 0;
    const Instruction* next = next_;
    outcome_ = Outcome::Yielded;
    const types::detail::RefusalWatch refusals;
    while (next) {
        try {
            do {
                at_ = next;
                next = next->act(*next, *this);
            } while (next && !until(next));
            if (next) stop(Outcome::Yielded, next);
            break;
        } catch (const internal::Interrupted& thrown) {
            next = interrupt(thrown.what());
        } catch (const FailedCall& thrown) {
            next = fail(thrown);
        } catch (const std::exception& thrown) {
            next = fail(thrown.what());
        } catch (...) {
            next = fail("something that is no std::exception was thrown");
        }
    }
    return outcome_;
}

Process::Outcome Process::run() {
    finishing_ = false;
    const Outcome outcome = execute([](const Instruction*) { return false; });
    if (!finishing_) return outcome;
    // pause() was called within a statement, so executes the rest of it.
    execute([this](const Instruction* next) { return codeOf(function_).beginsStatement(next); });
    if (outcome_ == Outcome::Yielded) outcome_ = Outcome::Paused;
    return outcome_;
}

Process::Outcome Process::runToEnd() {
    for (unsigned yields = 0; yields != kMostYields; ++yields) {
        const Outcome outcome = run();
        if (outcome != Outcome::Yielded) return outcome;
    }
    message_ = "yielded " + std::to_string(kMostYields) + " times, but has to be decided at once";
    failed_ = true;
    return Outcome::Failed;
}

Process::Outcome Process::runStatement() {
    pause_.store(false, std::memory_order_relaxed);
    return execute([this](const Instruction* next) { return codeOf(function_).beginsStatement(next); });
}

void Process::restart() {
    next_ = code_.begin();
    function_ = nullptr;
    started_ = failed_ = interrupted_ = false;
    message_.clear();
    failed_call_.reset();
    pause_.store(false, std::memory_order_relaxed);
    show(nullptr);
}

void Process::retry() {
    failed_ = interrupted_ = false;
    message_.clear();
    failed_call_.reset();
}

ast::Place Process::place() const {
    const Instruction* const at = shown_.load(std::memory_order_relaxed);
    return at ? code_.placeOf(at) : ast::Place{};
}

const Instruction* Process::stop(Outcome outcome, const Instruction* next) {
    outcome_ = outcome;
    next_ = next;
    if (outcome == Outcome::Finished) {
        next_ = code_.begin();
        started_ = false;
    }
    show(next);
    return nullptr;
}

void Process::show(const Instruction* at) {
    // Within a function, shows its outermost caller, because the place must be in this code.
    for (const Activation* inner = function_; inner; inner = inner->caller) at = inner->returnTo - 1;
    shown_.store(at, std::memory_order_relaxed);
}

const Instruction* Process::pauseAt(const Instruction* next) {
    pause_.store(false, std::memory_order_relaxed);
    if (codeOf(function_).beginsStatement(next)) return stop(Outcome::Paused, next);
    if (finishing_) return next;
    finishing_ = true;
    next_ = next;
    return nullptr;
}

const Instruction* Process::loseSight(const std::string& peer) {
    message_ = "component '" + peer +
               "' was destroyed, but its attributes or properties are used here; load this again without it";
    failed_ = true;
    return stop(Outcome::Failed, codeOf(function_).statementOf(at_));
}

const Instruction* Process::exceed(const Instruction* next) {
    rounds_ = 0;
    // Without a limit the number of rounds, an unsigned, has wrapped.
    if (round_limit_ == 0) return goOn(next);
    return fail("the loop went round " + std::to_string(round_limit_) +
                " times in one step of the component, which is the limit; add a 'yield' to it");
}

const Instruction* Process::fail(std::string message) {
    internal::Sending::announce({});  // forgets the announced call
    message_ = std::move(message);
    return catchFailure();
}

const Instruction* Process::fail(const FailedCall& call) {
    failed_call_ = std::make_unique<FailedCall>(call);
    return fail(std::string(call.what()));
}

CallPlace Process::placeIn(const Activation* function, const Instruction* at) const {
    const ast::Place place = codeOf(function).placeOf(at);
    CallPlace found{{function ? function->file : oroforge::diag::FileName(), place.line, place.column}, ""};
    if (const auto text = function ? function->text.lock() : nullptr) found.line = lineOf(*text, place.line);
    return found;
}

void Process::report(oroforge::diag::Sink& sink, const oroforge::diag::FileName& file, const std::string& whole) const {
    const oroforge::diag::Location here{file, place().line, place().column};
    if (failed_call_) return failed_call_->report(sink, here, whole);
    sink.error(here, interrupted_ ? "" : "OPS400", (whole.empty() ? whole : whole + " failed: ") + message_);
}

namespace {

/** True if the component that this thread executes is in Exception, because its own code threw. Its programs then
    stop. */
bool componentFailed() {
    const internal::EngineGate::Step* const step = internal::EngineGate::Step::innermost();
    const ExecutionEngine* const engine = step ? step->engine() : nullptr;
    const base::TaskCore* const task = engine ? engine->getTaskCore() : nullptr;
    return task && task->base::TaskCore::inException();
}

}  // namespace

const Instruction* Process::catchFailure() {
    Activation* const innermost = function_;
    const Instruction* at = at_;
    for (;;) {
        const Code& code = codeOf(function_);
        if (const Instruction* const handler = code.handlerOf(at)) {
            message_.clear();
            failed_call_.reset();
            return componentFailed() ? yieldTo(handler) : handler;
        }
        if (failed_call_) failed_call_->passes(placeIn(function_, at));
        if (!function_) break;
        if (failed_call_)
            failed_call_->leaves("function '" + function_->name + "' is called here");
        else
            message_ += " (at " + toString(placeIn(function_, at).where) + ", in function '" + function_->name + "')";
        at = function_->returnTo - 1;
        function_ = function_->caller;
    }
    function_ = innermost;
    failed_ = true;
    return stop(Outcome::Failed, codeOf(function_).statementOf(at_));
}

/** Fails without a chance to catch it. */
const Instruction* Process::interrupt(const char* why) {
    message_ = why;
    failed_ = interrupted_ = true;
    return stop(Outcome::Failed, codeOf(function_).statementOf(at_));
}

const Instruction* Process::enter(Activation& function, const Instruction* returnTo) {
    function.returnTo = returnTo;
    function.caller = function_;
    function_ = &function;
    return function.code.begin();
}

const Instruction* Process::leave() {
    if (!function_) return finish();
    const Instruction* const next = function_->returnTo;
    function_ = function_->caller;
    return next;
}

}  // namespace RTT::scripting::detail
