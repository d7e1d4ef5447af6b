// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations, and the handles of those that were sent.
#include "bindings.hpp"
#include "box.hpp"
#include "conversion.hpp"
#include "describe_operation.hpp"
#include "operation_call.hpp"
#include "state.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/SendStatus.hpp>
#include <rtt/internal/DataSources.hpp>

#include <memory>

namespace OCL::lua {

namespace {

typedef RTT::OperationInterfacePart Part;

typedef std::shared_ptr<OperationCall> CallPtr;

// A copy: the operation may delete its own box.
CallPtr callAt(lua_State* lua) { return boxAt<Operation>(lua, 1).call; }

int call(lua_State* lua) { return callAt(lua)->call(lua, 2); }

int send(lua_State* lua) {
    const CallPtr operation = callAt(lua);
    auto handle = operation->send(lua, 2);
    pushBox<SendHandle>(lua, operation->part(), std::move(handle));
    return 1;
}

int info(lua_State* lua) {
    const CallPtr operation = callAt(lua);
    pushOperationInfo(lua, operation->signature(), *operation->part());
    return 5;
}

int describe(lua_State* lua) {
    const CallPtr operation = callAt(lua);
    const OperationCall::Part& part = *operation->part();
    std::string text = part.resultType() + " " + part.getName() + "(";
    bool first = true;
    for (const RTT::ArgumentDescription& argument : part.getArgumentList()) {
        text += (first ? "" : ", ") + argument.type + (argument.name.empty() ? "" : " " + argument.name);
        first = false;
    }
    pushText(lua, text + ") // " + part.description());
    return 1;
}

/** Collects: pushes the status, and without variables the values. */
int collectFrom(lua_State* lua, bool wait) {
    const SendHandle handle = boxAt<SendHandle>(lua, 1);
    const int given = lua_gettop(lua) - 1;
    const unsigned arity = handle.part->collectArity();
    if (given != 0 && static_cast<unsigned>(given) != arity)
        throw Failure("operation '" + handle.part->getName() + "' gives " + std::to_string(arity) +
                      " values to collect, and " + std::to_string(given) + " Variables are here");
    Part::Args arguments{handle.handle};
    for (unsigned i = 1; i <= arity; ++i) {
        if (given) {
            const Variable& into = boxAt<Variable>(lua, static_cast<int>(i) + 1);
            into.life.check(Variable::kName);
            arguments.push_back(into.source);
            continue;
        }
        const RTT::types::TypeInfo* const type = handle.part->getCollectType(i);
        RTT::base::DataSourceBase::shared_ptr made = type ? type->buildValue() : nullptr;
        if (!made) throw Failure("a value of operation '" + handle.part->getName() + "' has an unknown type");
        arguments.push_back(made);
    }
    const RTT::internal::DataSource<bool>::shared_ptr blocking(new RTT::internal::ConstantDataSource<bool>(wait));
    const auto collecting = handle.part->produceCollect(arguments, blocking);
    RTT::SendStatus status = RTT::CollectFailure;
    if (auto* const source = RTT::internal::DataSource<RTT::SendStatus>::narrow(collecting.get())) {
        const State::Leave leave(State::of(lua));
        status = source->get();
    }
    const char* const names[] = {"CollectFailure", "SendFailure", "SendNotReady", "SendSuccess"};
    lua_pushstring(lua, names[status + 2]);
    if (given || status != RTT::SendSuccess) return 1;
    luaL_checkstack(lua, static_cast<int>(arity) + 8, "too many values");
    for (unsigned i = 1; i <= arity; ++i) pushValue(lua, arguments[i], Life());
    return 1 + static_cast<int>(arity);
}

int collect(lua_State* lua) { return collectFrom(lua, true); }
int collectIfDone(lua_State* lua) { return collectFrom(lua, false); }

}  // namespace

void bindOperation(lua_State* lua) {
    const luaL_Reg methods[] = {
        {"call", &guarded<&call>}, {"send", &guarded<&send>}, {"info", &guarded<&info>}, {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__call", &guarded<&call>}, {"__tostring", &guarded<&describe>}, {nullptr, nullptr}};
    registerKind<Operation>(lua, methods, events);
}

void bindSendHandle(lua_State* lua) {
    const luaL_Reg methods[] = {
        {"collect", &guarded<&collect>}, {"collectIfDone", &guarded<&collectIfDone>}, {nullptr, nullptr}};
    const luaL_Reg events[] = {{nullptr, nullptr}};
    registerKind<SendHandle>(lua, methods, events);
}

void pushOperation(lua_State* lua, const RTT::Service::shared_ptr& service, const std::string& name) {
    const RTT::OperationInterfacePart* const part = service->getPart(name);
    if (!part) throw Failure("'" + service->getName() + "' has no operation '" + name + "'");
    auto made = std::make_shared<OperationCall>(State::of(lua), Part::hold(part), Life(*service));
    pushBox<Operation>(lua, std::move(made));
}

}  // namespace OCL::lua
