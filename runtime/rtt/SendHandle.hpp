// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SEND_HANDLE_HPP
#define ORO_SEND_HANDLE_HPP

#include <rtt/internal/NA.hpp>
#include <rtt/internal/calls/typed_call.hpp>

#include <tuple>

namespace RTT {

template <class Signature>
class SendHandle;

/**
 * The result of OperationCaller::send(), now or later. Copies refer to the same call; the operation is executed even if
 * no copy is left. For the sending thread, or threads of its component.
 *
 * collect() waits (and blocks), collectIfDone() does not. Both take the result, if the operation has one, and then the
 * arguments it takes by non-const reference; or nothing. They throw std::runtime_error if the operation threw.
 */
template <class R, class... Args>
class SendHandle<R(Args...)> {
public:
    typedef internal::CallValues<R(Args...)> Call;

    SendHandle() = default;
    /** A null call is that of an operation that was refused. */
    explicit SendHandle(typename Call::shared_ptr call) : call_(std::move(call)) {}

    /** True if an operation was sent. */
    bool ready() const { return call_ != nullptr; }
    operator bool() const { return ready(); }

    template <class... Outs>
    SendStatus collect(Outs&... outs) const {
        return fetch(call_ ? call_->collect() : SendFailure, outs...);
    }
    template <class... Outs>
    SendStatus collectIfDone(Outs&... outs) const {
        return fetch(call_ ? call_->collectIfDone() : SendFailure, outs...);
    }
    /** The result; a default value while the operation is not done. */
    R ret() const {
        if (call_ && call_->collectIfDone() == SendSuccess) return call_->result.get();
        return internal::NA<R>::na();
    }
    /** The result, and the arguments changed by the operation. */
    template <class... All, std::enable_if_t<(sizeof...(All) == sizeof...(Args)) && (sizeof...(All) > 0), int> = 0>
    R ret(All&&... all) const {
        if (call_ && call_->collectIfDone() == SendSuccess) copyOut(std::index_sequence_for<Args...>(), all...);
        return ret();
    }
    const typename Call::shared_ptr& call() const { return call_; }

private:
    template <class... Outs>
    SendStatus fetch(SendStatus status, Outs&... outs) const {
        constexpr std::size_t results = std::is_void_v<R> ? 0 : 1;
        constexpr std::size_t references = (std::size_t(internal::isOutput<Args>) + ... + 0);
        static_assert(sizeof...(Outs) == 0 || sizeof...(Outs) == results + references,
                      "collect() takes the result and each argument that the operation takes by reference, or nothing");
        if constexpr (sizeof...(Outs) != 0) {
            if (status == SendSuccess) {
                auto outputs = std::tie(outs...);
                if constexpr (results == 1) std::get<0>(outputs) = call_->result.get();
                collectOut<results, 0>(outputs);
            }
        }
        return status;
    }
    template <std::size_t Out, std::size_t In, class Outputs>
    void collectOut(Outputs& outputs) const {
        if constexpr (In < sizeof...(Args) && Out < std::tuple_size_v<Outputs>) {
            if constexpr (internal::isOutput<std::tuple_element_t<In, std::tuple<Args...>>>) {
                std::get<Out>(outputs) = internal::argumentAt<In>(call_->arguments);
                collectOut<Out + 1, In + 1>(outputs);
            } else {
                collectOut<Out, In + 1>(outputs);
            }
        }
    }
    template <std::size_t... I, class... All>
    void copyOut(std::index_sequence<I...>, All&... all) const {
        (copyOne<Args>(all, internal::argumentAt<I>(call_->arguments)), ...);
    }
    template <class Arg, class To, class From>
    static void copyOne(To& to, const From& from) {
        if constexpr (internal::isOutput<Arg>) to = from;
        (void)to;
        (void)from;
    }

    typename Call::shared_ptr call_;
};

}  // namespace RTT

#endif
