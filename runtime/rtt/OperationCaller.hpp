// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_HPP
#define ORO_OPERATION_CALLER_HPP

#include <rtt/base/OperationCallerBase.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/internal/LocalOperationCaller.hpp>
#include <rtt/internal/NA.hpp>
#include <rtt/internal/calls/remote_operation.hpp>
#include <rtt/internal/calls/signature.hpp>

#include <memory>
#include <string>

namespace RTT {

class OperationInterfacePart;
class Service;

namespace internal {
/** The function of `part` for callers of that signature; null if it is remote. */
RTT_API base::DisposableInterface::shared_ptr localOperation(OperationInterfacePart* part,
                                                             const std::type_info& signature);
/** The operation `name` of `service`, or null. */
RTT_API OperationInterfacePart* findOperation(const boost::shared_ptr<Service>& service, const std::string& name);
RTT_API std::string operationName(OperationInterfacePart* part);
/** `holder.reset(held)`, compiled once for all signatures. */
RTT_API void hold(base::OperationCallerInterface::shared_ptr& holder, base::OperationCallerInterface* held);
/** True for types that can be the implementation of an operation. */
template <class T>
constexpr bool isImplementation = std::is_convertible_v<T*, base::DisposableInterface*>;
/** A boost pointer that shares ownership with `pointer`. */
template <class T>
base::DisposableInterface::shared_ptr held(const std::shared_ptr<T>& pointer) {
    return base::DisposableInterface::shared_ptr(pointer.get(), [pointer](base::DisposableInterface*) {});
}
}  // namespace internal

namespace base {
/** A caller without its signature, as service requesters hold it. */
class RTT_API OperationCallerBaseInvoker {
public:
    OperationCallerBaseInvoker() = default;
    explicit OperationCallerBaseInvoker(const std::string& name, ExecutionEngine* caller = nullptr)
        : name_(name), caller_(caller) {}
    virtual ~OperationCallerBaseInvoker();

    const std::string& getName() const { return name_; }
    virtual bool ready() const = 0;
    /** Binds to an operation; null unbinds. False, with an error logged, if it cannot be called with this signature. */
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
 * Calls an operation of this or another component. Operations that execute in their own component's thread need the
 * caller's engine: while it waits, the calling component continues to execute requests of others.
 *
 * call(): runs the operation in this thread, or blocks until its component has run it. Real-time safe if the operation
 * is and runs in this thread. Throws what the operation throws in this thread; std::runtime_error with its text if it
 * threw in another; SendError if its component takes no calls. If not ready(), call() returns a default value.
 * send(): never waits.
 *
 * An operation of another signature, or of another process, is called through data sources: arguments and result are
 * converted if the type system can; a caller without a result ignores that of the operation. Such a call is slower and
 * keeps copies of its arguments and result until the next one. It allocates the first time after setCaller(), and while
 * the caller is in use already; send() and all uses of its SendHandle always allocate. If a value cannot be converted,
 * or the result has no default value, an error names both signatures and the caller is not ready().
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
    /** From the result of Service::getLocalOperation() or Operation::getOperationCaller(). */
    template <class T, std::enable_if_t<internal::isImplementation<T>, int> = 0>
    OperationCaller(const boost::shared_ptr<T>& implementation, ExecutionEngine* caller = nullptr) {
        setImplementation(implementation, caller);
    }
    template <class T, std::enable_if_t<internal::isImplementation<T>, int> = 0>
    OperationCaller(const std::shared_ptr<T>& implementation, ExecutionEngine* caller = nullptr) {
        setImplementation(internal::held(implementation), caller);
    }
    /** A function that is not registered, called like an operation; in OwnThread `owner` executes it. */
    template <class Function, std::enable_if_t<std::is_invocable_r_v<R, Function&, Args...>, int> = 0>
    OperationCaller(const std::string& name, Function function, ExecutionEngine* owner = nullptr,
                    ExecutionEngine* caller = nullptr, ExecutionThread et = ClientThread)
        : OperationCallerBaseInvoker(name, caller) {
        auto* const made = new internal::LocalOperationCaller<Signature>();
        internal::hold(holder_, impl_ = made);
        made->setCallee(internal::makeCallee<Signature>(std::move(function)));
        made->setThread(et, owner);
        made->setCaller(caller);
    }
    template <class Member, class Object, std::enable_if_t<std::is_member_function_pointer_v<Member>, int> = 0>
    OperationCaller(const std::string& name, Member member, Object object, ExecutionEngine* owner = nullptr,
                    ExecutionEngine* caller = nullptr, ExecutionThread et = ClientThread)
        : OperationCaller(name, internal::BoundMember<Member, Object>{member, object}, owner, caller, et) {}
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
    /** Resolves its own name in the service. */
    OperationCaller& operator=(boost::shared_ptr<Service> service) {
        setImplementationPart(internal::findOperation(service, name_), caller_);
        return *this;
    }
    template <class T, std::enable_if_t<internal::isImplementation<T>, int> = 0>
    OperationCaller& operator=(const boost::shared_ptr<T>& implementation) {
        setImplementation(implementation, caller_);
        return *this;
    }
    template <class T, std::enable_if_t<internal::isImplementation<T>, int> = 0>
    OperationCaller& operator=(const std::shared_ptr<T>& implementation) {
        setImplementation(internal::held(implementation), caller_);
        return *this;
    }

    bool ready() const override { return holder_ && holder_->ready(); }
    operator bool() const { return ready(); }
    bool operator!() const { return !ready(); }

    R call(Args... args) const {
        return impl_ && impl_->isReady() ? impl_->call(std::forward<Args>(args)...) : callRemote(args...);
    }
    R operator()(Args... args) const {
        return impl_ && impl_->isReady() ? impl_->call(std::forward<Args>(args)...) : callRemote(args...);
    }
    SendHandle<Signature> send(Args... args) const {
        return impl_ && impl_->isReady() ? impl_->send(std::forward<Args>(args)...) : sendRemote(args...);
    }

    bool setImplementationPart(OperationInterfacePart* part, ExecutionEngine* caller = nullptr) override {
        if (caller) caller_ = caller;
        disconnect();
        if (!part) return false;
        const base::DisposableInterface::shared_ptr local = internal::localOperation(part, *signature().type);
        auto* typed = dynamic_cast<base::OperationCallerBase<Signature>*>(local.get());
        if (typed) impl_ = typed->cloneI(caller_);
        internal::hold(holder_, typed ? impl_ : internal::makeRemoteOperation(part, signature(), caller_));
        return ready();
    }
    bool setImplementation(base::DisposableInterface::shared_ptr implementation,
                           ExecutionEngine* caller = nullptr) override {
        if (caller) caller_ = caller;
        auto* typed = dynamic_cast<base::OperationCallerBase<Signature>*>(implementation.get());
        impl_ = typed ? typed->cloneI(caller_) : nullptr;
        internal::hold(holder_, typed || !implementation
                                    ? impl_
                                    : internal::copyRemoteOperation(*implementation, signature(), caller_, name_));
        return ready();
    }
    /** Null, even if ready(), for an operation of another signature or of another process. */
    const OperationCallerBasePtr getOperationCallerImpl() const { return OperationCallerBasePtr(holder_, impl_); }
    void disconnect() override {
        impl_ = nullptr;
        holder_.reset();
    }
    void setCaller(ExecutionEngine* caller) override {
        caller_ = caller;
        if (holder_) holder_->setCaller(caller);
    }

private:
    static const internal::CallerSignature& signature() { return internal::CallerSignatureOf<Signature>::signature; }
    // Also for a caller that is not ready, which returns the default value.
    [[gnu::noinline]] R callRemote(std::remove_reference_t<Args>&... args) const {
        void* const all[] = {const_cast<void*>(static_cast<const volatile void*>(std::addressof(args)))..., nullptr};
        if constexpr (std::is_void_v<R> || std::is_reference_v<R>) {
            internal::callRemoteOperation(holder_, all, nullptr);
            return internal::NA<R>::na();
        } else {
            internal::ValueOf<R> result = internal::NA<internal::ValueOf<R>>::na();
            internal::callRemoteOperation(holder_, all, std::addressof(result));
            return result;
        }
    }
    SendHandle<Signature> sendRemote(const std::remove_reference_t<Args>&... args) const {
        typedef internal::CallValues<Signature> Call;
        if (!ready()) return SendHandle<Signature>();
        const typename Call::shared_ptr call(new Call(nullptr, args...));
        void* result = nullptr;
        if constexpr (!std::is_void_v<R> && !std::is_reference_v<R>) {
            call->result.take(&internal::NA<R>::na);
            result = const_cast<void*>(call->result.address());
        }
        return internal::sendRemoteOperation(holder_, *call.get(), sizeof...(Args), result)
                   ? SendHandle<Signature>(call)
                   : SendHandle<Signature>();
    }

    base::OperationCallerInterface::shared_ptr holder_;
    base::OperationCallerBase<Signature>* impl_ = nullptr;  // the object of holder_; null if that has another signature
};

}  // namespace RTT

#endif
