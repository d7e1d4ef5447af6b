// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls through the data sources of an operation that is remote or has another signature than the caller.
#ifndef ORO_INTERNAL_REMOTE_OPERATION_HPP
#define ORO_INTERNAL_REMOTE_OPERATION_HPP

#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/internal/calls/typed_call.hpp>

#include <string>
#include <type_traits>
#include <typeinfo>

namespace RTT {
class OperationInterfacePart;
namespace internal {

/** An argument that a caller passes, or the result that it expects. */
struct CallerValue {
    const std::type_info* type;  ///< without reference and const
    bool isConstant;             ///< an argument by const reference, which must not be changed
    bool isOutput;               ///< an argument by reference, which is changed
};

/** The signature of a caller as a constant table, so that the code that works on it is not a template. */
struct CallerSignature {
    const std::type_info* type;
    unsigned arity;
    const CallerValue* values;  ///< the result, then the arguments
    /** Assigns a result; null if there is none, or it cannot be assigned or has no default value. */
    void (*assignResult)(void* to, const void* from);
};

template <class T>
void assignValueOf(void* to, const void* from) {
    *static_cast<T*>(to) = *static_cast<const T*>(from);
}
template <class R>
constexpr auto resultAssigner() -> void (*)(void*, const void*) {
    if constexpr (!std::is_void_v<R> && !std::is_reference_v<R> && std::is_copy_assignable_v<ValueOf<R>> &&
                  std::is_default_constructible_v<ValueOf<R>>)
        return &assignValueOf<ValueOf<R>>;
    else
        return nullptr;
}
template <class T>
constexpr CallerValue callerValue() {
    return {&typeid(ValueOf<T>), std::is_lvalue_reference_v<T> && !isOutput<T>, isOutput<T>};
}
template <class Signature>
struct CallerSignatureOf;
template <class R, class... A>
struct CallerSignatureOf<R(A...)> {
    static constexpr CallerValue values[] = {callerValue<R>(), callerValue<A>()...};
    static constexpr CallerSignature signature = {&typeid(R(A...)), sizeof...(A), values, resultAssigner<R>()};
};

/** A new object that calls `part` with another signature than its own. Null, with an error logged that names both
    signatures, if that is impossible. */
RTT_API base::OperationCallerInterface* makeRemoteOperation(const OperationInterfacePart* part,
                                                            const CallerSignature& signature, ExecutionEngine* caller);
/** Another object like `held`; null, with an error logged, if that was made for another signature. */
RTT_API base::OperationCallerInterface* copyRemoteOperation(const base::DisposableInterface& held,
                                                            const CallerSignature& signature, ExecutionEngine* caller,
                                                            const std::string& name);
/**
 * Calls `held`, which one of the functions above made, with pointers to the arguments, and assigns the result if there
 * is one. Does nothing if it is null or not ready. Throws what the operation throws; SendError if it was not executed;
 * std::runtime_error if it was, but its result could not be converted. `held` may be reset meanwhile. Allocates after a
 * change of the caller, and if a call is in progress already, in another thread or further up the stack. Keeps copies
 * of the arguments and of the result until the next call.
 */
RTT_API void callRemoteOperation(const base::OperationCallerInterface::shared_ptr& held, void* const* arguments,
                                 void* result);
/** The same without waiting; `call` holds copies of the arguments and the result. False if refused. Allocates. */
RTT_API bool sendRemoteOperation(const base::OperationCallerInterface::shared_ptr& held, SentCall& call, unsigned arity,
                                 void* result);

}  // namespace internal
}  // namespace RTT

#endif
