// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_HPP
#define ORO_OPERATION_CALLER_HPP

#include <rtt/base/OperationCallerBase.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/internal/NA.hpp>
#include <rtt/internal/Signature.hpp>

#include <string>

namespace RTT {

class OperationInterfacePart;
class Service;

namespace internal {
/** The operation behind `part`, to be narrowed to its signature; null if there is none in this process. */
RTT_API base::OperationCallerInterface::shared_ptr localOperation(OperationInterfacePart* part);
/** The operation `name` of `service`, or null. */
RTT_API OperationInterfacePart* findOperation(const boost::shared_ptr<Service>& service, const std::string& name);
RTT_API std::string operationName(OperationInterfacePart* part);
/** `holder.reset(held)`, compiled once for all signatures. */
RTT_API void hold(base::OperationCallerInterface::shared_ptr& holder, base::OperationCallerInterface* held);
/** Logs that a caller with another signature was bound to an operation. */
RTT_API void logWrongSignature(const std::string& name, const char* wanted);
}  // namespace internal

namespace base {
/** A caller without its signature, as requesters hold it. */
class RTT_API OperationCallerBaseInvoker {
public:
    OperationCallerBaseInvoker() = default;
    explicit OperationCallerBaseInvoker(const std::string& name, ExecutionEngine* caller = nullptr)
        : name_(name), caller_(caller) {}
    virtual ~OperationCallerBaseInvoker();

    const std::string& getName() const { return name_; }
    virtual bool ready() const = 0;
    /** Binds to an operation; null unbinds. False if its signature differs. */
    virtual bool setImplementationPart(OperationInterfacePart* part, ExecutionEngine* caller = nullptr) = 0;
    virtual bool setImplementation(DisposableInterface::shared_ptr implementation,
                                   ExecutionEngine* caller = nullptr) = 0;
    virtual void disconnect() = 0;
    virtual void setCaller(ExecutionEngine* caller) = 0;

protected:
    std::string name_;
    ExecutionEngine* caller_ = nullptr;
};
}  // namespace base

/**
 * Calls an operation of this or another component. The caller's engine is needed to call operations that execute in
 * their own component's thread: while it waits, the calling component goes on executing what others ask of it.
 *
 * call(): runs the operation in this thread, or waits until its component has; blocks then. Real-time safe if the
 * operation is and runs in this thread. Throws what the operation throws in this thread; std::runtime_error if it threw
 * in another; SendError if its component takes no calls. If not ready(), call() returns a default value.
 * send(): never waits.
 */
template <class Signature>
class OperationCaller;

template <class R, class... Args>
class OperationCaller<R(Args...)> : public base::OperationCallerBaseInvoker {
public:
    typedef R Signature(Args...);
    typedef R result_type;
    typedef boost::shared_ptr<base::OperationCallerBase<Signature>> OperationCallerBasePtr;

    OperationCaller() = default;
    explicit OperationCaller(const std::string& name, ExecutionEngine* caller = nullptr)
        : OperationCallerBaseInvoker(name, caller) {}
    explicit OperationCaller(const char* name, ExecutionEngine* caller = nullptr)
        : OperationCallerBaseInvoker(name, caller) {}
    /** Idiom: `OperationCaller<bool(int)> f = peer->getOperation("f");` */
    OperationCaller(OperationInterfacePart* part, ExecutionEngine* caller = nullptr)
        : OperationCallerBaseInvoker(internal::operationName(part), caller) {
        setImplementationPart(part, caller);
    }
    OperationCaller(const std::string& name, boost::shared_ptr<Service> service, ExecutionEngine* caller = nullptr)
        : OperationCallerBaseInvoker(name, caller) {
        setImplementationPart(internal::findOperation(service, name), caller);
    }
    /** From what Service::getLocalOperation() gives. */
    OperationCaller(base::DisposableInterface::shared_ptr implementation, ExecutionEngine* caller = nullptr) {
        setImplementation(implementation, caller);
    }
    OperationCaller(const OperationCaller& other) : OperationCallerBaseInvoker(other.name_, other.caller_) {
        setImplementation(other.holder_, other.caller_);
    }
    OperationCaller& operator=(const OperationCaller& other) {
        if (this == &other) return *this;
        name_ = other.name_;
        setImplementation(other.holder_, other.caller_ ? other.caller_ : caller_);
        return *this;
    }
    OperationCaller& operator=(OperationInterfacePart* part) {
        if (part && name_.empty()) name_ = internal::operationName(part);
        setImplementationPart(part, caller_);
        return *this;
    }
    /** Looks its own name up in the service. */
    OperationCaller& operator=(boost::shared_ptr<Service> service) {
        setImplementationPart(internal::findOperation(service, name_), caller_);
        return *this;
    }
    OperationCaller& operator=(base::DisposableInterface::shared_ptr implementation) {
        setImplementation(implementation, caller_);
        return *this;
    }

    bool ready() const override { return impl_ && impl_->ready(); }
    operator bool() const { return ready(); }
    bool operator!() const { return !ready(); }

    R call(Args... args) const { return ready() ? impl_->call(std::forward<Args>(args)...) : internal::NA<R>::na(); }
    R operator()(Args... args) const {
        return ready() ? impl_->call(std::forward<Args>(args)...) : internal::NA<R>::na();
    }
    SendHandle<Signature> send(Args... args) const {
        return ready() ? impl_->send(std::forward<Args>(args)...) : SendHandle<Signature>();
    }

    bool setImplementationPart(OperationInterfacePart* part, ExecutionEngine* caller = nullptr) override {
        if (!part) {
            disconnect();
            return false;
        }
        return setImplementation(internal::localOperation(part), caller);
    }
    bool setImplementation(base::DisposableInterface::shared_ptr implementation,
                           ExecutionEngine* caller = nullptr) override {
        if (caller) caller_ = caller;
        auto* typed = dynamic_cast<base::OperationCallerBase<Signature>*>(implementation.get());
        if (implementation && !typed) internal::logWrongSignature(name_, typeid(Signature).name());
        impl_ = typed ? typed->cloneI(caller_) : nullptr;
        internal::hold(holder_, impl_);
        return ready();
    }
    const OperationCallerBasePtr getOperationCallerImpl() const { return OperationCallerBasePtr(holder_, impl_); }
    void disconnect() override {
        impl_ = nullptr;
        holder_.reset();
    }
    void setCaller(ExecutionEngine* caller) override {
        caller_ = caller;
        if (impl_) impl_->setCaller(caller);
    }

private:
    base::OperationCallerInterface::shared_ptr holder_;
    base::OperationCallerBase<Signature>* impl_ = nullptr;  // what holder_ holds
};

}  // namespace RTT

#endif
