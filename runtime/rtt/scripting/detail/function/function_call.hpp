// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The execution of a script's function for somebody who is not a script of the same component.
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_CALL_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_CALL_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/internal/EngineGate.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

class FunctionPool;

/** What all executions of a function have in common. */
struct FunctionOwner {
    std::string function, component;
    oroforge::diag::FileName file;
    std::weak_ptr<const std::string> text;                  ///< of the file
    boost::intrusive_ptr<const internal::EngineGate> gate;  ///< of the engine that executes it
    decltype(Surroundings::roundLimit) roundLimit;
    std::atomic<bool> warned{false};  ///< that it yields where nobody expects it

    /** "function 'f' of component 'c'" */
    std::string describe() const { return "function '" + function + "' of component '" + component + "'"; }
};

/**
 * An activation of a function with the one who executes it: the caller itself in the thread of the owner, otherwise the
 * owner's engine, first as a message and then, if it yields, as a function in the steps to come, which goes on also while
 * the component waits for another one. Used for one call after the
 * other. Referred to by the source that calls, by handles, and by the engine while it has it; goes back to its pool when
 * nobody does any more. Nothing here allocates unless it says so, or the function or what it calls does.
 *
 * State Waiting belongs to the thread that executes, every other state to the one that calls. finish() hands it over.
 */
class FunctionCall final : public base::DisposableInterface, public base::ExecutableInterface {
public:
    typedef boost::intrusive_ptr<FunctionCall> shared_ptr;
    typedef base::DataSourceBase::shared_ptr Source;

    FunctionCall(std::shared_ptr<FunctionOwner> owner, std::unique_ptr<Activation> activation,
                 std::shared_ptr<const Peers> peers);
    ~FunctionCall() override;

    const FunctionOwner& owner() const { return *owner_; }
    /** Of the types that the function takes, for begin(). */
    const std::vector<Source>& arguments() const { return activation_->arguments; }
    /** Null for void. To be read after call(), or when collect() gave SendSuccess. */
    const Source& result() const { return activation_->result; }

    /** Takes the values of these sources, which have been evaluated, as arguments. False if it is being executed. */
    bool begin(const std::vector<Source>& values);
    /** After begin(): executes it and waits for its end. `caller`, the gate of the component that calls, or null, matters to
        threads that stand for that component. Throws std::runtime_error if the function fails, SendError if it is not
        executed; blocks. */
    void call(const internal::EngineGate* caller);
    /** After begin(): has it executed by its engine, also in the thread of that. False if it is refused. */
    bool send(const internal::EngineGate* caller);
    /** What became of it; waits for its end if `wait`. Throws as call() does if it failed. */
    SendStatus collect(bool wait);

    // For the engine.
    void executeAndDispose() override;
    void dispose() override;
    bool isError() const override { return state_.load() == Failed; }
    bool execute() override;
    bool isAwaited() const override { return true; }
    void unloaded() override;

    friend void intrusive_ptr_add_ref(FunctionCall* call) { call->references_.fetch_add(1, std::memory_order_relaxed); }
    friend void intrusive_ptr_release(FunctionCall* call);
    /** Nobody but one handle or source refers to it. */
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
    const Source noResult_;  // what the result is before a call
    Process process_;
    Process::Outcome outcome_ = Process::Outcome::Yielded;
    std::atomic<bool> executing_{false};  // further down the stack of the thread that executes
    bool listed_ = false;                 // among the functions of the engine, or on its way there
    bool sent_ = false;                   // maybe nobody will ever ask what became of it
    boost::intrusive_ptr<const internal::EngineGate>
        waiting_;  // of the engine whose thread waits; null: done_ is enough
    internal::WaitPoint done_;
    std::atomic<State> state_{Idle};
    std::atomic<int> references_{0};
    std::shared_ptr<FunctionPool> pool_;  // null while it is in there
    FunctionCall* next_ = nullptr;        // in there
};

}  // namespace RTT::scripting::detail

#endif
