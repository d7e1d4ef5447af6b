// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_LOCAL_OPERATION_CALLER_HPP
#define ORO_LOCAL_OPERATION_CALLER_HPP

#include <rtt/base/OperationCallerBase.hpp>
#include <rtt/internal/calls/spare_calls.hpp>

#include <memory>

namespace RTT {
namespace internal {

template <class Signature>
class LocalOperationCaller;

/** An operation of a component in this process. Shares its function with the Operation object and with its clones. */
template <class R, class... Args>
class LocalOperationCaller<R(Args...)> final : public base::OperationCallerBase<R(Args...)> {
public:
    typedef boost::shared_ptr<LocalOperationCaller> shared_ptr;
    typedef Callee<R(Args...)> Function;
    typedef TypedCall<R(Args...)> Sent;

    LocalOperationCaller() = default;

    R call(Args... args) override {
        {
            const EngineGate::Stand direct = this->direct();
            if (direct) return (*static_cast<Function*>(this->callee()))(std::forward<Args>(args)...);
        }
        const Held held(spares_, this->callee(), args...);
        Sent& sent = *held.call;
        this->enqueueAndWait(sent);
        copyBack(sent, std::index_sequence_for<Args...>(), args...);
        return sent.result.get();
    }
    SendHandle<R(Args...)> send(Args... args) override {
        auto* const sent = static_cast<Sent*>(this->enqueueNew(new Sent(this->callee(), args...)));
        return SendHandle<R(Args...)>(typename Sent::shared_ptr(sent, false));
    }
    LocalOperationCaller* cloneI(ExecutionEngine* caller) const override {
        return new LocalOperationCaller(*this, caller);
    }

private:
    /** In place of spare calls, for a signature whose calls are not kept. */
    struct Pool {};
    typedef std::conditional_t<keepsCalls<R(Args...)>, std::shared_ptr<SpareCalls<Sent>>, Pool> Spares;
    /** Gives a call back at its end, unless the caller was interrupted and the call still waits. It refers to nothing
        in the LocalOperationCaller, which may be gone by then, see enqueueAndWait(). */
    struct Held {
        Held(const Spares& from, CalleeBase* callee, std::remove_reference_t<Args>&... args)
            : spares(from), call(take(callee, args...)) {}
        ~Held() {
            if constexpr (keepsCalls<R(Args...)>)
                if (call->state() != SentCall::Waiting) spares->give(call);
        }
        typename Sent::shared_ptr take(CalleeBase* callee, std::remove_reference_t<Args>&... args) const {
            if constexpr (keepsCalls<R(Args...)>)
                return spares->take(callee, args...);
            else
                return new Sent(callee, args...);
        }
        const Spares spares;
        const typename Sent::shared_ptr call;
    };
    static Spares makeSpares() {
        if constexpr (keepsCalls<R(Args...)>)
            return std::make_shared<SpareCalls<Sent>>();
        else
            return {};
    }

    LocalOperationCaller(const LocalOperationCaller& other, ExecutionEngine* caller)
        : base::OperationCallerBase<R(Args...)>(other, caller) {}

    template <std::size_t... I>
    static void copyBack(Sent& sent, std::index_sequence<I...>, std::remove_reference_t<Args>&... args) {
        (copyOne<Args>(args, argumentAt<I>(sent.arguments)), ...);
        (void)sent;
    }
    template <class Arg, class To, class From>
    static void copyOne(To& to, From& from) {
        if constexpr (isOutput<Arg>) to = from;
        (void)to;
        (void)from;
    }

    const Spares spares_ = makeSpares();
};

}  // namespace internal
}  // namespace RTT

#endif
