// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ERASED_FUNCTION_HPP
#define ORO_ERASED_FUNCTION_HPP

#include <rtt/base/DataSourceBase.hpp>
#include "FunctionSignature.hpp"
#include "StructTable.hpp"
#include <array>
#include <memory>
#include <utility>

namespace RTT {
namespace types {

/** Computes `result` (an existing value) from the arguments; false if there is no result, for example of 1 / 0. */
using ComputeFunction = bool (*)(const void* context, const void* const* arguments, void* result);

/** A function of values whose types are known only by name. */
struct ErasedFunction {
    static constexpr std::size_t maxArity = 12;

    ComputeFunction call = nullptr;
    std::shared_ptr<const void> context;  ///< the function object
    TypeRef result = nullptr;
    std::size_t arity = 0;
    std::array<TypeRef, maxArity> arguments{};

    RTT_API bool accepts(std::size_t position, const base::DataSourceBase& argument) const;
    /**
     * A source that calls the function whenever it is evaluated; real-time safe if the function is.
     * Null if an argument is of another type or the result type is not registered.
     */
    RTT_API base::DataSourceBase::shared_ptr apply(
        const std::vector<base::DataSourceBase::shared_ptr>& arguments) const;
};

namespace detail {

template <class F, class R, class... A>
struct ErasedCall {
    static bool call(const void* context, const void* const* arguments, void* result) {
        // Function objects may have a non-const call operator; they are not shared between threads.
        auto& f = *const_cast<F*>(static_cast<const F*>(context));
        return callWith(f, arguments, result, std::index_sequence_for<A...>());
    }
    template <std::size_t... I>
    static bool callWith(F& f, const void* const* a, void* r, std::index_sequence<I...>) {
        (void)a;
        *static_cast<std::decay_t<R>*>(r) = f(*static_cast<std::decay_t<A>*>(const_cast<void*>(a[I]))...);
        return true;
    }
};

template <class F, class R, class... A>
ErasedFunction eraseAs(F f, Signature<R(A...)>) {
    static_assert(sizeof...(A) <= ErasedFunction::maxArity, "at most twelve arguments");
    ErasedFunction erased;
    erased.call = &ErasedCall<F, R, A...>::call;
    erased.context = std::make_shared<F>(std::move(f));
    erased.result = &typeRef<std::decay_t<R>>;
    erased.arity = sizeof...(A);
    erased.arguments = {&typeRef<std::decay_t<A>>...};
    return erased;
}

}  // namespace detail

/** From a function pointer, or a function object with a known signature. */
template <class F>
ErasedFunction eraseFunction(F f) {
    return detail::eraseAs(std::move(f), typename detail::SignatureOf<F>::type());
}

}  // namespace types
}  // namespace RTT

#endif
