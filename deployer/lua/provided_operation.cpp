// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "provided_operation.hpp"

#include "provided_call.hpp"
#include "read_signature.hpp"
#include "state.hpp"
#include "values.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>

namespace OCL::lua {

using RTT::base::DataSourceBase;

namespace {

typedef RTT::OperationInterfacePart::Args Args;
typedef std::shared_ptr<const ProvidedFunction> Function;
typedef RTT::internal::DataSource<ProvidedCall::shared_ptr> Handle;
typedef boost::intrusive_ptr<const RTT::internal::EngineGate> Gate;

Args copies(const Args& arguments, RTT::internal::CopyMap& cloned) {
    Args made;
    for (const auto& argument : arguments) made.push_back(argument->copy(cloned));
    return made;
}

/** A call with the values that the arguments have now. */
ProvidedCall::shared_ptr newCall(const Function& function, const Args& arguments) {
    for (const auto& argument : arguments)
        if (!argument->evaluate()) throw Failure("an argument of " + function->describe() + " cannot be evaluated");
    return new ProvidedCall(function, arguments);
}

class CallAction final : public RTT::base::ActionInterface {
public:
    CallAction(Function function, Args arguments, Gate caller, DataSourceBase::shared_ptr result)
        : function_(std::move(function)),
          arguments_(std::move(arguments)),
          caller_(std::move(caller)),
          result_(std::move(result)) {}
    void readArguments() override {}
    bool execute() override {
        const ProvidedCall::shared_ptr call = newCall(function_, arguments_);
        call->call(caller_.get());
        for (std::size_t i = 0; i != arguments_.size(); ++i) {
            if (!function_->signature.arguments[i].isOutput()) continue;
            arguments_[i]->assignValue(call->arguments()[i]->getRawConstPointer());
            arguments_[i]->updated();
        }
        return !result_ || result_->assignValue(call->result()->getRawConstPointer());
    }
    CallAction* clone() const override { return new CallAction(function_, arguments_, caller_, result_); }
    CallAction* copy(RTT::internal::CopyMap& cloned) const override {
        return new CallAction(function_, copies(arguments_, cloned), caller_,
                              result_ ? result_->copy(cloned) : nullptr);
    }

private:
    const Function function_;
    const Args arguments_;
    const Gate caller_;
    const DataSourceBase::shared_ptr result_;
};

class SendSource final : public Handle {
public:
    SendSource(Function function, Args arguments) : function_(std::move(function)), arguments_(std::move(arguments)) {}
    bool evaluate() const override { return get() != nullptr; }
    ProvidedCall::shared_ptr get() const override {
        sent_ = newCall(function_, arguments_);
        if (!sent_->send()) sent_.reset();
        return sent_;
    }
    ProvidedCall::shared_ptr value() const override { return sent_; }
    const ProvidedCall::shared_ptr& rvalue() const override { return sent_; }
    SendSource* clone() const override { return new SendSource(function_, arguments_); }
    SendSource* copy(RTT::internal::CopyMap& cloned) const override {
        return new SendSource(function_, copies(arguments_, cloned));
    }

private:
    const Function function_;
    const Args arguments_;
    mutable ProvidedCall::shared_ptr sent_;
};

class CollectSource final : public RTT::internal::DataSource<RTT::SendStatus> {
public:
    CollectSource(Function function, Handle::shared_ptr handle, Args variables,
                  RTT::internal::DataSource<bool>::shared_ptr blocking)
        : function_(std::move(function)),
          handle_(std::move(handle)),
          variables_(std::move(variables)),
          blocking_(std::move(blocking)) {}
    RTT::SendStatus get() const override {
        const ProvidedCall::shared_ptr call = handle_->get();
        if (!call) return status_ = RTT::SendFailure;
        status_ = call->collect(!blocking_ || blocking_->get(), nullptr);
        if (status_ != RTT::SendSuccess || variables_.empty()) return status_;
        Args values;
        if (call->result()) values.push_back(call->result());
        for (std::size_t i = 0; i != call->arguments().size(); ++i)
            if (function_->signature.arguments[i].isOutput()) values.push_back(call->arguments()[i]);
        for (std::size_t i = 0; i != variables_.size(); ++i) {
            if (i >= values.size() || !variables_[i]->assignValue(values[i]->getRawConstPointer()))
                return status_ = RTT::CollectFailure;
            variables_[i]->updated();
        }
        return status_;
    }
    RTT::SendStatus value() const override { return status_; }
    const RTT::SendStatus& rvalue() const override { return status_; }
    CollectSource* clone() const override { return new CollectSource(function_, handle_, variables_, blocking_); }
    CollectSource* copy(RTT::internal::CopyMap& cloned) const override {
        return new CollectSource(function_, static_cast<Handle*>(handle_->copy(cloned)), copies(variables_, cloned),
                                 blocking_);
    }

private:
    const Function function_;
    const Handle::shared_ptr handle_;
    const Args variables_;
    const RTT::internal::DataSource<bool>::shared_ptr blocking_;
    mutable RTT::SendStatus status_ = RTT::SendNotReady;
};

class ProvidedPart final : public RTT::internal::SignedPart {
public:
    explicit ProvidedPart(Function function) : function_(std::move(function)) {}

    const ProvidedFunction& function() const { return *function_; }
    std::string getName() const override { return function_->name; }
    std::string description() const override { return function_->description; }
    RTT::internal::OperationSignature signature() const override { return function_->signature; }

    DataSourceBase::shared_ptr produce(const Args& args, RTT::ExecutionEngine* caller) const override {
        const Args arguments = checkedArguments(args);
        const Gate gate = caller ? caller->gate() : nullptr;
        const auto& result = function_->signature.result;
        if (result.isVoid()) {
            const boost::shared_ptr<CallAction> action(new CallAction(function_, arguments, gate, nullptr));
            return new RTT::internal::FusedFunctorDataSource<void()>([action] { action->execute(); }, Args());
        }
        const DataSourceBase::shared_ptr value = result.type->buildValue();
        return result.type->buildActionAlias(new CallAction(function_, arguments, gate, value), value);
    }
    DataSourceBase::shared_ptr produceSend(const Args& args, RTT::ExecutionEngine*) const override {
        return new SendSource(function_, checkedArguments(args));
    }
    DataSourceBase::shared_ptr produceHandle() const override {
        return new RTT::internal::ValueDataSource<ProvidedCall::shared_ptr>();
    }
    DataSourceBase::shared_ptr produceCollect(const Args& args,
                                              RTT::internal::DataSource<bool>::shared_ptr blocking) const override {
        const Handle::shared_ptr handle = Handle::narrow(args.empty() ? nullptr : args[0].get());
        checkCollected(args, handle != nullptr);
        return new CollectSource(function_, handle, Args(args.begin() + 1, args.end()), std::move(blocking));
    }

private:
    const Function function_;
};

/** What the table or text at index 5 says. */
void readOptions(lua_State* lua, ProvidedFunction& function) {
    if (lua_isnoneornil(lua, 5)) return;
    if (!lua_istable(lua, 5)) {
        function.description = textAt(lua, 5);
        return;
    }
    lua_getfield(lua, 5, "doc");
    function.description = textAt(lua, -1, "");
    lua_getfield(lua, 5, "thread");
    const std::string thread = textAt(lua, -1, "ClientThread");
    if (thread != "ClientThread" && thread != "OwnThread")
        throw Failure("the thread of an operation is 'ClientThread' or 'OwnThread', not '" + thread + "'");
    function.ownThread = thread == "OwnThread";
    lua_pop(lua, 2);
}

}  // namespace

void provideOperation(lua_State* lua, RTT::Service& service) {
    State& state = State::of(lua);
    const auto function = std::make_shared<ProvidedFunction>();
    function->name = textAt(lua, 2);
    if (function->name.empty()) throw Failure("an operation needs a name");
    function->signature = readSignature(textAt(lua, 3));
    if (!lua_isfunction(lua, 4)) throw Failure("operation '" + function->name + "' needs a function as argument 4");
    const RTT::OperationInterfacePart* const taken = service.getPart(function->name);
    if (taken && !isProvidedHere(lua, taken))
        throw Failure("'" + service.getName() + "' has an operation '" + function->name + "' already");
    RTT::TaskContext* const owner = service.getOwner();
    function->component = owner ? owner->getName() : service.getName();
    function->ownThread = false;
    readOptions(lua, *function);
    function->gate = (owner ? *owner : state.owner()).engine()->gate();
    lua_pushvalue(lua, 4);
    function->reference = luaL_ref(lua, LUA_REGISTRYINDEX);
    function->state = state.weak_from_this();
    function->stateGate = state.owner().engine()->gate();
    service.add(function->name, new ProvidedPart(function));
}

bool isProvidedHere(lua_State* lua, const RTT::OperationInterfacePart* part) {
    const auto* const provided = dynamic_cast<const ProvidedPart*>(part);
    return provided && provided->function().state.lock().get() == &State::of(lua);
}

}  // namespace OCL::lua
