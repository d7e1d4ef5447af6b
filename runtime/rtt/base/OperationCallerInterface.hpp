// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_INTERFACE_HPP
#define ORO_OPERATION_CALLER_INTERFACE_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/rtt-config.h>

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
class WaitPoint;
}  // namespace internal

namespace base {

/** An operation as its callers hold it, without its signature. */
class RTT_API OperationCallerInterface {
public:
    typedef boost::shared_ptr<OperationCallerInterface> shared_ptr;

    virtual ~OperationCallerInterface();
    /** True if there is a function to call. */
    virtual bool ready() const = 0;
    /** Which thread executes, and the engine of the component that provides the operation. */
    void setThread(ExecutionThread et, ExecutionEngine* owner) {
        thread_ = et;
        owner_ = owner;
    }
    ExecutionThread getThread() const { return thread_; }
    ExecutionEngine* getOwner() const { return owner_; }
    /** The engine of the component that calls: while that waits, it executes its own messages. */
    void setCaller(ExecutionEngine* caller) { caller_ = caller; }
    ExecutionEngine* getCaller() const { return caller_; }

    /** The same operation for another caller; the caller of this function owns it. */
    virtual OperationCallerInterface* cloneFor(ExecutionEngine* caller) const = 0;

    /** True if a call has to be sent to another thread. */
    bool isSend() const;

protected:
    OperationCallerInterface() = default;
    OperationCallerInterface(const OperationCallerInterface&) = default;

    /** Hands the call to the engine that executes it; the reference of the queue is taken. False if refused. */
    bool enqueue(internal::SentCall& call) const;
    /** The same and waits for its end. Throws SendError. */
    void enqueueAndWait(internal::SentCall& call) const;

private:
    ExecutionThread thread_ = ClientThread;
    ExecutionEngine* owner_ = nullptr;
    ExecutionEngine* caller_ = nullptr;
};

}  // namespace base
}  // namespace RTT

#endif
