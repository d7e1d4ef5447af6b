// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_LOCAL_OPERATION_CALLER_HPP
#define ORO_LOCAL_OPERATION_CALLER_HPP

#include <rtt/base/OperationCallerBase.hpp>

namespace RTT {
namespace internal {

template <class Signature>
class LocalOperationCaller;

/** An operation of a component in this process. Shares its function with the Operation object and with its clones. */
template <class R, class... Args>
class LocalOperationCaller<R(Args...)> final : public base::OperationCallerBase<R(Args...)> {
public:
    typedef boost::shared_ptr<LocalOperationCaller> shared_ptr;
    typedef typename Callee<R(Args...)>::shared_ptr Function;
    typedef TypedCall<R(Args...)> Sent;

    LocalOperationCaller() = default;

    bool ready() const override { return callee_ != nullptr && !this->isGone(); }
    void setFunction(Function function) { callee_ = std::move(function); }
    const Function& function() const { return callee_; }
    CalleeBase* callee() const override { return callee_.get(); }

    R call(Args... args) override {
        if (!this->isSend()) return (*callee_)(std::forward<Args>(args)...);
        typename Sent::shared_ptr sent(new Sent(callee_, args...));
        this->enqueueAndWait(*sent);
        copyBack(*sent, std::index_sequence_for<Args...>(), args...);
        return sent->result.get();
    }
    SendHandle<R(Args...)> send(Args... args) override {
        typename Sent::shared_ptr sent(new Sent(callee_, args...));
        if (!this->enqueue(*sent)) sent = nullptr;
        return SendHandle<R(Args...)>(std::move(sent));
    }
    LocalOperationCaller* cloneI(ExecutionEngine* caller) const override {
        auto* made = new LocalOperationCaller(*this);
        made->setCaller(caller);
        return made;
    }

private:
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

    Function callee_;
};

}  // namespace internal
}  // namespace RTT

#endif
