// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An operation that a Lua function executes, and its calls.
#ifndef OCL_LUA_PROVIDED_CALL_HPP
#define OCL_LUA_PROVIDED_CALL_HPP

#include "state.hpp"

#include <rtt/SendStatus.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/internal/engine/wait_point.hpp>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace OCL::lua {

/** What all calls of one operation share. */
struct ProvidedFunction {
    std::string name, component, description;
    RTT::internal::OperationSignature signature;
    bool ownThread;  ///< the component's thread executes it
    std::weak_ptr<State> state;
    int reference;                                                    ///< of the function, in the registry of Lua
    boost::intrusive_ptr<const RTT::internal::EngineGate> gate;       ///< of the component that has the operation
    boost::intrusive_ptr<const RTT::internal::EngineGate> stateGate;  ///< of the one that has the function

    ~ProvidedFunction();
    /** "operation 'f' of component 'c'" */
    std::string describe() const { return "operation '" + name + "' of component '" + component + "'"; }
};

/** One call. The thread that calls makes it and fills the arguments; then it belongs to the thread that executes. */
class ProvidedCall final : public RTT::base::DisposableInterface {
public:
    typedef boost::intrusive_ptr<ProvidedCall> shared_ptr;
    typedef RTT::base::DataSourceBase::shared_ptr Source;

    /** Copies the values of the arguments, which were evaluated. Throws Failure. */
    ProvidedCall(std::shared_ptr<const ProvidedFunction> function, const std::vector<Source>& arguments);

    /** Executes it, or has the component execute it, and waits. Throws std::runtime_error if it fails. */
    void call(const RTT::internal::EngineGate* caller);
    /** Has the component execute it. False if that refuses. */
    bool send();
    /** Throws std::runtime_error if the function failed. */
    RTT::SendStatus collect(bool wait, const RTT::internal::EngineGate* caller);

    const std::vector<Source>& arguments() const { return arguments_; }
    /** Null for void. */
    const Source& result() const { return result_; }

    void executeAndDispose() override;
    void dispose() override;
    bool isError() const override { return status_.load() == Status::Failed; }

    friend void intrusive_ptr_add_ref(ProvidedCall* call) { call->references_.fetch_add(1); }
    friend void intrusive_ptr_release(ProvidedCall* call) {
        if (call->references_.fetch_sub(1) == 1) delete call;
    }

private:
    enum class Status { Waiting, Done, Failed, Refused };
    void execute();
    void run();
    void runFunction(lua_State* lua);
    void finish(Status status);
    void wait(const RTT::internal::EngineGate* caller);

    const std::shared_ptr<const ProvidedFunction> function_;
    std::vector<Source> arguments_;
    Source result_;
    std::string error_;
    RTT::internal::WaitPoint done_;
    boost::intrusive_ptr<const RTT::internal::EngineGate> waiting_;
    std::atomic<Status> status_{Status::Waiting};
    std::atomic<int> references_{0};
};

}  // namespace OCL::lua

#endif
