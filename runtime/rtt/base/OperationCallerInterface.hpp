// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_INTERFACE_HPP
#define ORO_OPERATION_CALLER_INTERFACE_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/internal/calls/callee.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

#include <boost/shared_ptr.hpp>

#include <stdexcept>

namespace RTT {
class ExecutionEngine;

/** Which thread executes an operation: that of the component that provides it, or the caller's. */
enum ExecutionThread { OwnThread, ClientThread };

/** Thrown by call() if the operation never ran, because its component takes no messages (FatalError, no activity, queue
    full) or call() was used without a caller. */
class RTT_API SendError : public std::runtime_error {
public:
    SendError(SendStatus status, const std::string& why);
    SendStatus status() const { return status_; }

private:
    SendStatus status_;
};

namespace internal {
class SentCall;
}  // namespace internal

namespace base {

/** An operation as its callers hold it, without its signature. Not a message, but code for RTT 2 holds it as one. */
class RTT_API OperationCallerInterface : public DisposableInterface {
public:
    typedef boost::shared_ptr<OperationCallerInterface> shared_ptr;

    ~OperationCallerInterface() override;
    void executeAndDispose() final {}
    void dispose() final {}
    /** True if there is a function to call and the component that provides it exists. */
    virtual bool ready() const { return isReady(); }
    /** The same without a virtual call. */
    bool isReady() const { return callee_ && !isGone(); }
    /** Which thread executes, and the engine of the component that provides the operation. */
    void setThread(ExecutionThread et, ExecutionEngine* owner);
    ExecutionThread getThread() const { return thread_; }
    /** Null if there is none or it was destroyed. */
    ExecutionEngine* getOwner() const { return owner_ ? owner_->engine() : nullptr; }
    /** The engine of the component that calls: while that waits, it executes its own messages. */
    void setCaller(ExecutionEngine* caller) { caller_ = caller; }
    ExecutionEngine* getCaller() const { return caller_; }

    /** The same operation for another caller; the caller of this function owns it. */
    virtual OperationCallerInterface* cloneI(ExecutionEngine* caller) const = 0;
    OperationCallerInterface* cloneFor(ExecutionEngine* caller) const { return cloneI(caller); }

    /** The function and its signal; null if there is none, or none in this process. */
    internal::CalleeBase* callee() const { return callee_.get(); }
    void setCallee(internal::CalleeBase* callee);

    /** True if a call has to be sent to another thread. */
    bool isSend() const;
    /** For callers that send by data sources, as scripts do: an exception of the operation in the GlobalEngine now puts
        the component that provides it into Exception. */
    void setGeneric() { generic_ = true; }
    /** For a caller by data sources that executed the operation itself, which threw `what`; see internal::blame(). */
    void ownerThrew(const char* what) const;

protected:
    OperationCallerInterface() = default;
    /** For cloneI(). */
    OperationCallerInterface(const OperationCallerInterface& other, ExecutionEngine* caller);

    /** True if the component that provides this was destroyed. */
    bool isGone() const { return owner_ && owner_->closed(); }
    /** Converts to true if the caller may execute the operation itself while it exists; otherwise the call is sent. */
    internal::EngineGate::Stand direct() const {
        return internal::EngineGate::Stand(thread_ == OwnThread ? owner_.get() : nullptr);
    }
    /** Gives the call, with a reference for the queue, to the engine that executes it. False if refused. */
    bool enqueue(internal::SentCall& call) const;
    /** The same with a new call; returns it with a reference for the caller. Null if refused. */
    internal::SentCall* enqueueNew(internal::SentCall* call) const;
    /** The same, but waits for the end of the call. Throws SendError. */
    void enqueueAndWait(internal::SentCall& call) const;

private:
    ExecutionThread thread_ = ClientThread;
    bool generic_ = false;
    boost::intrusive_ptr<internal::CalleeBase> callee_;
    boost::intrusive_ptr<const internal::EngineGate> owner_;
    ExecutionEngine* caller_ = nullptr;
};

}  // namespace base
}  // namespace RTT

#endif
