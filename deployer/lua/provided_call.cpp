// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "provided_call.hpp"

#include "conversion.hpp"
#include "values.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/os/fosi.h>

namespace OCL::lua {

using RTT::internal::EngineGate;

ProvidedFunction::~ProvidedFunction() {
    const std::shared_ptr<State> known = state.lock();
    if (!known) return;
    std::string error;
    (void)known->protect(error, [this](lua_State* lua) { luaL_unref(lua, LUA_REGISTRYINDEX, reference); });
}

ProvidedCall::ProvidedCall(std::shared_ptr<const ProvidedFunction> function, const std::vector<Source>& arguments)
    : function_(std::move(function)) {
    const auto& signature = function_->signature;
    for (std::size_t i = 0; i != arguments.size(); ++i) {
        const Source copy = signature.arguments[i].type->buildValue();
        if (!copy || !copy->assignValue(arguments[i]->getRawConstPointer()))
            throw Failure("argument " + std::to_string(i + 1) + " of " + function_->describe() + " has no value");
        arguments_.push_back(copy);
    }
    if (!signature.result.isVoid()) result_ = signature.result.type->buildValue();
}

void ProvidedCall::call(const EngineGate* caller) {
    if (!function_->ownThread) {
        execute();
    } else {
        const EngineGate::Stand here(function_->gate.get());
        if (here)
            execute();
        else if (!send())
            throw RTT::SendError(RTT::SendFailure, function_->describe() + " was refused by the component");
    }
    (void)collect(true, caller);
}

bool ProvidedCall::send() {
    const EngineGate* const own = EngineGate::ofThisThread();
    waiting_ = own;
    intrusive_ptr_add_ref(this);  // the queue's
    if (RTT::ExecutionEngine::process(*function_->gate, this)) return true;
    dispose();
    return false;
}

RTT::SendStatus ProvidedCall::collect(bool waits, const EngineGate* caller) {
    if (waits) wait(caller);
    switch (status_.load()) {
        case Status::Waiting: return RTT::SendNotReady;
        case Status::Done: return RTT::SendSuccess;
        case Status::Failed: throw std::runtime_error(error_);
        case Status::Refused: break;
    }
    if (waits) throw RTT::SendError(RTT::SendFailure, function_->describe() + " was not executed");
    return RTT::SendFailure;
}

void ProvidedCall::wait(const EngineGate* caller) {
    constexpr std::int64_t kMillisecond = 1000000;
    const auto over = [this] { return status_.load() != Status::Waiting; };
    const EngineGate* const own = EngineGate::ofThisThread()   ? EngineGate::ofThisThread()
                                  : caller && caller->isSelf() ? caller
                                                               : nullptr;
    while (!over()) {
        // Nothing wakes this thread if the component is destroyed, or if another thread sent the call.
        const std::int64_t soon = rtos_get_time_ns() + (own == waiting_.get() ? 100 : 1) * kMillisecond;
        if (own) {
            own->engine()->waitForMessages(over, soon);
        } else {
            const std::uint32_t ticket = done_.ticket();
            if (!over()) done_.wait(ticket, soon);
        }
        Status waiting = Status::Waiting;
        if (function_->gate->closed()) status_.compare_exchange_strong(waiting, Status::Refused);
    }
}

void ProvidedCall::executeAndDispose() {
    const shared_ptr queued(this, false);
    execute();
}

void ProvidedCall::dispose() {
    const shared_ptr queued(this, false);
    finish(Status::Refused);
}

void ProvidedCall::finish(Status status) {
    const boost::intrusive_ptr<const EngineGate> waiting = waiting_;
    Status now = Status::Waiting;
    status_.compare_exchange_strong(now, status);
    done_.notify();
    if (waiting) waiting->waitPoint.notify();
}

void ProvidedCall::execute() {
    try {
        run();
    } catch (const std::exception& error) {
        error_ = function_->describe() + " failed: " + error.what();
        return finish(Status::Failed);
    }
    finish(Status::Done);
}

void ProvidedCall::runFunction(lua_State* lua) {
    const auto& signature = function_->signature;
    luaL_checkstack(lua, static_cast<int>(signature.arguments.size()) + 8, "too many arguments");
    const int before = lua_gettop(lua);
    lua_rawgeti(lua, LUA_REGISTRYINDEX, function_->reference);
    for (std::size_t i = 0; i != signature.arguments.size(); ++i)
        pushCopy(lua, State::of(lua).conversion(signature.arguments[i].type), *arguments_[i]);
    lua_call(lua, static_cast<int>(signature.arguments.size()), LUA_MULTRET);
    int next = before + 1;
    if (result_) {
        if (lua_gettop(lua) < next) throw Failure("it returns nothing instead of a " + signature.result.typeName);
        try {
            assign(lua, next++, *result_);
        } catch (const Failure& why) {
            throw Failure(std::string("its result: ") + why.what());
        }
    }
    // New values of the arguments that it changes follow.
    for (std::size_t i = 0; i != signature.arguments.size(); ++i)
        if (signature.arguments[i].isOutput() && next <= lua_gettop(lua)) assign(lua, next++, *arguments_[i]);
}

void ProvidedCall::run() {
    // As long as it is visited, no other thread destroys the component that has the state.
    const EngineGate::Visit visit(*function_->stateGate);
    const std::shared_ptr<State> state = visit.engine() ? function_->state.lock() : nullptr;
    if (!state) throw Failure("its component was destroyed");
    const RTT::internal::HookInProgress here(&state->owner(), "an operation in Lua");
    std::string error;
    const double limit = function_->ownThread ? state->limit.load(std::memory_order_relaxed) : 0;
    const auto limited = [&](lua_State* lua) {
        const State::Limit most(*state, limit);
        runFunction(lua);
    };
    if (!state->protect(error, limited)) throw Failure(error);
}

}  // namespace OCL::lua
