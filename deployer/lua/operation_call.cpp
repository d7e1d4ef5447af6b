// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "operation_call.hpp"

#include "box.hpp"
#include "busy.hpp"
#include "conversion.hpp"
#include "state.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/internal/engine/interruption.hpp>

namespace OCL::lua {

OperationCall::OperationCall(State& state, Part::shared_constptr part, Life life)
    : state_(state),
      part_(std::move(part)),
      signature_(part_->signature()),
      life_(std::move(life)),
      result_(&state.conversion(signature_.result.isVoid() ? RTT::internal::DataSource<void>::GetTypeInfo()
                                                           : signature_.result.type)) {
    prepare();
}

/** Now, because the first call may come from a real-time thread. */
void OperationCall::prepare() {
    Part::Args made;
    for (const auto& argument : signature_.arguments) {
        made.push_back(argument.type ? argument.type->buildValue() : nullptr);
        if (!made.back()) return;
    }
    call_ = part_->produce(made, state_.caller());
    kept_ = std::move(made);
}

void OperationCall::fail(const std::string& why) const {
    throw Failure("operation '" + part_->getName() + "': " + why);
}

void OperationCall::check(lua_State* lua, int first) const {
    life_.check(Operation::kName);
    const std::size_t given = static_cast<std::size_t>(lua_gettop(lua) - first + 1);
    if (given != signature_.arguments.size())
        fail("it takes " + std::to_string(signature_.arguments.size()) + " arguments, not " + std::to_string(given));
}

bool OperationCall::canReuse(lua_State* lua, int first) const {
    if (busy_ || !call_) return false;
    for (std::size_t i = 0; i != signature_.arguments.size(); ++i) {
        if (signature_.arguments[i].isOutput() && findBox<Variable>(lua, first + static_cast<int>(i))) return false;
    }
    return true;
}

OperationCall::Source OperationCall::newArgument(std::size_t index) const {
    const auto& argument = signature_.arguments[index];
    Source made = argument.type ? argument.type->buildValue() : nullptr;
    if (!made)
        fail("argument " + std::to_string(index + 1) + " has type " + argument.typeName +
             ", for which only a Variable of that type can be given");
    return made;
}

OperationCall::Part::Args OperationCall::arguments(lua_State* lua, int first) const {
    Part::Args made;
    for (std::size_t i = 0; i != signature_.arguments.size(); ++i) {
        const int at = first + static_cast<int>(i);
        const auto& argument = signature_.arguments[i];
        const Variable* const variable = findBox<Variable>(lua, at);
        if (variable) variable->life.check(Variable::kName);
        if (variable && (argument.isOutput() || !argument.type)) {
            made.push_back(variable->source);
            continue;
        }
        made.push_back(newArgument(i));
        try {
            assign(lua, at, *made.back());
        } catch (const Failure& why) {
            fail("argument " + std::to_string(i + 1) + ": " + why.what());
        }
    }
    return made;
}

void OperationCall::evaluate(const Source& call) {
    bool done = false;
    try {
        const State::Leave leave(state_);
        done = call->evaluate();
    } catch (const RTT::internal::Interrupted&) {
        throw;
    } catch (const std::exception& error) {
        const std::string why = error.what(), named = "operation '" + part_->getName() + "'";
        if (why.compare(0, named.size(), named) == 0) throw Failure(why);
        fail(why);
    }
    if (!done) fail("it was not executed");
}

int OperationCall::call(lua_State* lua, int first) {
    check(lua, first);
    if (!canReuse(lua, first)) {
        const Source once = part_->produce(arguments(lua, first), state_.caller());
        evaluate(once);
        pushCopy(lua, *result_, *once);
        return 1;
    }
    const Busy busy(busy_);
    for (std::size_t i = 0; i != kept_.size(); ++i) {
        try {
            assign(lua, first + static_cast<int>(i), *kept_[i]);
        } catch (const Failure& why) {
            fail("argument " + std::to_string(i + 1) + ": " + why.what());
        }
    }
    evaluate(call_);
    pushCopy(lua, *result_, *call_);
    return 1;
}

OperationCall::Source OperationCall::send(lua_State* lua, int first) {
    check(lua, first);
    const Source sending = part_->produceSend(arguments(lua, first), state_.caller());
    Source handle = part_->produceHandle();
    bool sent = false;
    try {
        const State::Leave leave(state_);
        sent = handle && handle->update(sending.get());
    } catch (const std::exception& error) {
        fail(error.what());
    }
    if (!sent) fail("it could not be sent");
    return handle;
}

}  // namespace OCL::lua
