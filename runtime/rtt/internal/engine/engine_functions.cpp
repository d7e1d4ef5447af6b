// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/engine_functions.hpp>

#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/detail/function_removal.hpp>
#include <rtt/internal/engine/detail/guarded_call.hpp>

namespace RTT::internal {

EngineFunctions::~EngineFunctions() {
    list_.forEach([](base::ExecutableInterface& function) { function.unloaded(); });
}

void EngineFunctions::remove(FunctionRemoval& removal) {
    list_.remove(removal.function);
    if (executing_ != removal.function) return removal.finish(FunctionRemoval::Removed);
    // Its execute() is waiting, further down the stack.
    removal.next = removals_;
    removals_ = &removal;
}

/** True if the function has to be executed again. */
bool EngineFunctions::execute(const Step& here, base::ExecutableInterface& function) const {
    bool again = false;
    detail::guarded(here, task_, "a function", [&] { again = function.execute(); });
    return again;
}

void EngineFunctions::process(const Step& here, FunctionList::Round round) {
    list_.takeWoken();
    while (base::ExecutableInterface* const function = list_.next(round)) {
        if (task_ && task_->base::TaskCore::inFatalError()) return;
        if (task_ && task_->base::TaskCore::inException() && function->pausesInException()) continue;
        executing_ = function;
        const bool again = execute(here, *function);
        if (here.gone()) return;
        executing_ = nullptr;
        if (list_.has(round, function)) {
            if (again)
                list_.rest(round);
            else
                unload(round, *function);
        }
        while (FunctionRemoval* const removal = removals_) {
            removals_ = removal->next;
            removal->finish(FunctionRemoval::Removed);
        }
        list_.takeWoken();
    }
    list_.tidy();
}

bool EngineFunctions::processAwaited(const Step& here) {
    bool left = false;
    FunctionList::Round round = list_.begin();
    while (base::ExecutableInterface* const function = list_.next(round)) {
        if (task_ && task_->base::TaskCore::inFatalError()) return false;
        if (function == executing_ || !function->isAwaited()) continue;
        const bool again = execute(here, *function);
        if (here.gone()) return false;
        left = left || again;
        if (!again && list_.has(round, function)) unload(round, *function);
    }
    return left;
}

void EngineFunctions::unload(const FunctionList::Round& round, base::ExecutableInterface& function) {
    list_.drop(round);
    function.unloaded();
}

}  // namespace RTT::internal
