// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What users of an operation need if they do not know its signature: one constant table per signature. The code that
// works on these tables is not a template, because every operation of every component would pay for it.
#ifndef ORO_INTERNAL_OPERATION_TABLE_HPP
#define ORO_INTERNAL_OPERATION_TABLE_HPP

#include <rtt/base/OperationCallerBase.hpp>
#include <rtt/internal/calls/call_source.hpp>

#include <typeinfo>

namespace RTT {
namespace internal {

/** The type of an argument or a result. */
struct ValueType {
    const std::type_info* id;  ///< without reference and const
    types::TypeInfo* (*info)();
    bool isConst, isReference, isPointer;

    bool isOutput() const { return isReference && !isConst; }
};

struct OperationTable {
    unsigned arity;
    const ValueType* types;  ///< the result, then the arguments
    /** Calls with pointers to the arguments; `result` is a ResultStore<R>. */
    void (*invoke)(base::OperationCallerInterface& caller, void* const* arguments, void* result);
    /** Sends; null if refused. */
    SentCall::shared_ptr (*send)(base::OperationCallerInterface& caller, void* const* arguments);
    /** A new source of the result's type that evaluates the call. */
    base::DataSourceBase* (*makeSource)(GenericCall&& call);
    /** The type of the call that `send` makes. */
    const std::type_info* sentType;
};

template <class T>
constexpr ValueType valueType() {
    using Referred = std::remove_reference_t<T>;
    return {&typeid(ValueOf<T>), &DataSourceTypeInfo<ValueOf<T>>::getTypeInfo, std::is_const_v<Referred>,
            std::is_reference_v<T>, std::is_pointer_v<Referred>};
}

template <class Signature>
struct OperationTableOf;
template <class R, class... A>
struct OperationTableOf<R(A...)> {
    static void invoke(base::OperationCallerInterface& caller, void* const* arguments, void* result) {
        static_cast<ResultStore<R>*>(result)->take(
            [&]() -> R { return callWith(caller, arguments, std::index_sequence_for<A...>()); });
    }
    static SentCall::shared_ptr send(base::OperationCallerInterface& caller, void* const* arguments) {
        return sendWith(caller, arguments, std::index_sequence_for<A...>());
    }
    static base::DataSourceBase* makeSource(GenericCall&& call) { return new CallSource<R>(std::move(call)); }

    static constexpr ValueType types[] = {valueType<R>(), valueType<A>()...};
    static constexpr OperationTable table = {sizeof...(A), types,       &invoke,
                                             &send,        &makeSource, &typeid(TypedCall<R(A...)>)};

private:
    typedef base::OperationCallerBase<R(A...)> Caller;
    // A source gives its value to several calls, so a value that would be moved from is copied.
    template <class Arg>
    using Passed = std::conditional_t<std::is_rvalue_reference_v<Arg>, ValueOf<Arg>, Arg>;

    template <std::size_t... I>
    static R callWith(base::OperationCallerInterface& caller, void* const* arguments, std::index_sequence<I...>) {
        (void)arguments;
        return static_cast<Caller&>(caller).call(static_cast<Passed<A>>(*static_cast<ValueOf<A>*>(arguments[I]))...);
    }
    template <std::size_t... I>
    static SentCall::shared_ptr sendWith(base::OperationCallerInterface& caller, void* const* arguments,
                                         std::index_sequence<I...>) {
        (void)arguments;
        return static_cast<Caller&>(caller)
            .send(static_cast<Passed<A>>(*static_cast<ValueOf<A>*>(arguments[I]))...)
            .call();
    }
};

}  // namespace internal
}  // namespace RTT

#endif
