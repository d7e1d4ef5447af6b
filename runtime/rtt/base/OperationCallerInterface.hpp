// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_INTERFACE_HPP
#define ORO_OPERATION_CALLER_INTERFACE_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/internal/Callee.hpp>
#include <rtt/internal/EngineGate.hpp>

#include <boost/shared_ptr.hpp>

#include <stdexcept>

namespace RTT {
class ExecutionEngine;

/** Where an operation is executed: by the component that provides it, or by whoever calls. */
enum ExecutionThread { OwnThread, ClientThread };

/** Thrown by call(): the operation never ran, because its component takes no messages (FatalError, no activity, queue full),
    or because call() was used without a caller. */
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

/** An operation as its callers hold it, without its signature. No message, but held as one by code written for RTT 2. */
class RTT_API OperationCallerInterface : public DisposableInterface {
public:
    typedef boost::shared_ptr<OperationCallerInterface> shared_ptr;

    ~OperationCallerInterface() override;
    void executeAndDispose() final {}
    void dispose() final {}
    /** True if there is a function to call and the component that provides it exists. */
    virtual bool ready() const { return isReady(); }
    /** The same, for a call that must not take longer than necessary. */
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
    /** From now on, what the operation throws in the GlobalEngine puts the component that provides it into Exception: for
        those who send by data sources, as scripts do. */
    void setGeneric() { generic_ = true; }
    /** A caller by data sources executed the operation itself, and it threw that: see internal::blame(). */
    void ownerThrew(const char* what) const;

protected:
    OperationCallerInterface() = default;
    /** For cloneI(). */
    OperationCallerInterface(const OperationCallerInterface& other, ExecutionEngine* caller);

    /** The component that provides this was destroyed. */
    bool isGone() const { return owner_ && owner_->closed(); }
    /** Converts to true if the caller may execute the operation itself, as long as it lives; else the call has to be sent. */
    internal::EngineGate::Stand direct() const {
        return internal::EngineGate::Stand(thread_ == OwnThread ? owner_.get() : nullptr);
    }
    /** Hands the call to the engine that executes it; the reference of the queue is taken. False if refused. */
    bool enqueue(internal::SentCall& call) const;
    /** The same with a call that nobody holds yet; gives it with a reference for the caller. Null if refused. */
    internal::SentCall* enqueueNew(internal::SentCall* call) const;
    /** The same and waits for its end. Throws SendError. */
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
