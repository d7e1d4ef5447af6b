// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Executes a function of a script for callers other than scripts of the same component.
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_CALL_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_CALL_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

class FunctionPool;

/** What all executions of a function share. */
struct FunctionOwner {
    std::string function, component;
    oroforge::diag::FileName file;
    std::weak_ptr<const std::string> text;                  ///< the text of the file
    boost::intrusive_ptr<const internal::EngineGate> gate;  ///< the gate of the engine that executes it
    decltype(CompileContext::roundLimit) roundLimit;
    std::atomic<bool> warned{false};  ///< a warning was given that it yields unexpectedly

    /** "function 'f' of component 'c'" */
    std::string describe() const { return "function '" + function + "' of component '" + component + "'"; }
};

/**
 * An activation of a function and its execution. In the thread of the owner, the caller executes it. Otherwise the
 * owner's engine does, first as a message and then, if it yields, as a function in later steps, even while the
 * component waits for another one. It is reused for one call after another. The source that calls, handles, and the
 * engine refer to it; without references it goes back to its pool. Functions here do not allocate unless they say so,
 * or the called function does.
 *
 * In state Waiting it belongs to the thread that executes, in other states to the caller. finish() hands it over.
 */
class FunctionCall final : public base::DisposableInterface, public base::ExecutableInterface {
public:
    typedef boost::intrusive_ptr<FunctionCall> shared_ptr;
    typedef base::DataSourceBase::shared_ptr Source;

    FunctionCall(std::shared_ptr<FunctionOwner> owner, std::unique_ptr<Activation> activation,
                 std::shared_ptr<const Peers> peers);
    ~FunctionCall() override;

    const FunctionOwner& owner() const { return *owner_; }
    /** Values of the types that the function takes, for begin(). */
    const std::vector<Source>& arguments() const { return activation_->arguments; }
    /** The result; null for void. Read it after call(), or when collect() gave SendSuccess. */
    const Source& result() const { return activation_->result; }

    /** Copies the values of these sources, which were evaluated, to the arguments. False if it is being executed. */
    bool begin(const std::vector<Source>& values);
    /**
     * After begin(): executes it and waits for its end. `caller`, the gate of the calling component or null, matters to
     * threads that act for that component. Throws std::runtime_error if the function fails, SendError if it is not
     * executed; blocks.
     */
    void call(const internal::EngineGate* caller);
    /** After begin(): sends it to its engine, even from the thread of that. False if it is refused. */
    bool send(const internal::EngineGate* caller);
    /** The status; with `wait`, waits for the end. Throws as call() does if it failed. */
    SendStatus collect(bool wait);

    // Called by the engine.
    void executeAndDispose() override;
    void dispose() override;
    bool isError() const override { return state_.load() == Failed; }
    bool execute() override;
    bool isAwaited() const override { return true; }
    void unloaded() override;

    friend void intrusive_ptr_add_ref(FunctionCall* call) { call->references_.fetch_add(1, std::memory_order_relaxed); }
    friend void intrusive_ptr_release(FunctionCall* call);
    /** True if only one handle or source refers to it. */
    bool isUnused() const { return references_.load(std::memory_order_acquire) == 1; }

private:
    friend class FunctionPool;
    enum State { Idle, Waiting, Done, Failed, Refused };
    bool enqueue(const internal::EngineGate* caller);
    bool executePart();
    void executeHere();
    void serveMessages();
    void goOn();
    void wait();
    bool isLost() const;
    void settle();
    void finish(State state);
    std::string failure() const;
    void reportFailure() const;
    void checkFailure() const;

    const std::shared_ptr<FunctionOwner> owner_;
    const std::unique_ptr<Activation> activation_;
    const Source noResult_;  // the result before a call
    Process process_;
    Process::Outcome outcome_ = Process::Outcome::Yielded;
    std::atomic<bool> executing_{false};  // it is on the stack of the thread that executes
    bool listed_ = false;                 // in the functions of the engine, or about to be
    bool sent_ = false;                   // it may never be collected
    boost::intrusive_ptr<const internal::EngineGate>
        waiting_;  // the engine whose thread waits; null if done_ is enough
    internal::WaitPoint done_;
    std::atomic<State> state_{Idle};
    std::atomic<int> references_{0};
    std::shared_ptr<FunctionPool> pool_;  // null while it is in the pool
    FunctionCall* next_ = nullptr;        // the next one in the pool
};

}  // namespace RTT::scripting::detail

#endif
