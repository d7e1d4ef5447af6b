// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The function of an operation, shared by all its callers.
#ifndef ORO_INTERNAL_CALLEE_HPP
#define ORO_INTERNAL_CALLEE_HPP

#include <rtt/rtt-config.h>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <utility>

namespace boost {
template <typename Signature>
class function;
}

namespace RTT {
namespace base {
struct OperationDescription;
}
namespace internal {

class SignalBase;

class RTT_API CalleeBase {
public:
    CalleeBase() = default;
    virtual ~CalleeBase();
    CalleeBase(const CalleeBase&) = delete;
    CalleeBase& operator=(const CalleeBase&) = delete;

    void ref() const { references_.fetch_add(1, std::memory_order_relaxed); }
    void deref() const;

    /** At most once; other threads may be calling meanwhile. */
    void listen(std::shared_ptr<SignalBase> signal);
    /** Takes over the signal of the callee that this one replaces, if it has one. */
    void listenLike(const CalleeBase* other);
    const std::shared_ptr<SignalBase>& signal() const { return signal_; }
    /** Names the operation that this function belongs to. Before the first call. */
    void belongsTo(std::shared_ptr<const base::OperationDescription> operation);
    /** Empty if the function belongs to no operation. */
    std::string operationName() const;

protected:
    const SignalBase* listeners() const { return listeners_.load(std::memory_order_acquire); }
    /** Calls the subscribers of the signal with pointers to the arguments. */
    static void emit(const SignalBase& signal, void* const* arguments);

private:
    mutable std::atomic<int> references_{0};
    std::atomic<const SignalBase*> listeners_{nullptr};
    std::shared_ptr<SignalBase> signal_;
    std::shared_ptr<const base::OperationDescription> operation_;
};

/** "operation 'name'", for messages; `callee` may be null. */
RTT_API std::string describe(const CalleeBase* callee);

inline void intrusive_ptr_add_ref(const CalleeBase* callee) { callee->ref(); }
inline void intrusive_ptr_release(const CalleeBase* callee) { callee->deref(); }

template <class Signature>
class Callee;
template <class R, class... Args>
class Callee<R(Args...)> : public CalleeBase {
public:
    typedef boost::intrusive_ptr<Callee> shared_ptr;

    R operator()(Args... args) {
        if (const SignalBase* signal = listeners()) {
            void* const all[] = {const_cast<void*>(static_cast<const volatile void*>(std::addressof(args)))...,
                                 nullptr};
            emit(*signal, all);
        }
        return call(std::forward<Args>(args)...);
    }

protected:
    virtual R call(Args... args) = 0;
};

template <class Signature, class Function>
class BoundCallee;
template <class R, class... Args, class Function>
class BoundCallee<R(Args...), Function> final : public Callee<R(Args...)> {
public:
    explicit BoundCallee(Function function) : function_(std::move(function)) {}

private:
    R call(Args... args) override { return static_cast<R>(function_(std::forward<Args>(args)...)); }
    Function function_;
};

/** True for pointers and function objects that hold nothing to call. */
template <class F>
bool isEmptyFunction(const F&) {
    return false;
}
template <class R, class... A>
bool isEmptyFunction(R (*const& f)(A...)) {
    return !f;
}
template <class S>
bool isEmptyFunction(const boost::function<S>& f) {
    return f.empty();
}

/** A new callee that calls `function`; null if that is empty. */
template <class Signature, class Function>
CalleeBase* makeCallee(Function&& function) {
    return isEmptyFunction(function) ? nullptr : new BoundCallee<Signature, Function>(std::forward<Function>(function));
}

}  // namespace internal
}  // namespace RTT

#endif
