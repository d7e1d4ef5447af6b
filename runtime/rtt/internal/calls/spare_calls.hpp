// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_SPARE_CALLS_HPP
#define ORO_INTERNAL_SPARE_CALLS_HPP

#include <rtt/internal/calls/typed_call.hpp>

#include <array>
#include <atomic>
#include <string>
#include <type_traits>
#include <vector>

namespace RTT {
namespace internal {

/** True for values that own what they hold and can always be assigned: numbers, texts, and vectors and arrays of such.
    Others may differ: a struct may have constants in its vectors, and a map of a matrix writes through. */
template <class T>
struct IsPlainValue : std::bool_constant<std::is_arithmetic_v<T> || std::is_enum_v<T>> {};
template <class Char, class Traits, class Allocator>
struct IsPlainValue<std::basic_string<Char, Traits, Allocator>> : std::true_type {};
template <class T, class Allocator>
struct IsPlainValue<std::vector<T, Allocator>> : IsPlainValue<T> {};
template <class T, std::size_t N>
struct IsPlainValue<std::array<T, N>> : IsPlainValue<T> {};

/** True for signatures whose arguments own memory, so that keeping their copies saves allocations. */
template <class Signature>
constexpr bool keepsCalls = false;
template <class R, class... Args>
constexpr bool keepsCalls<R(Args...)> =
    !(std::is_trivially_copyable_v<ValueOf<Args>> && ...) && (IsPlainValue<ValueOf<Args>>::value && ...) &&
    (std::is_void_v<R> || IsPlainValue<ValueOf<R>>::value);

/**
 * Executed calls, kept for the next ones of the same caller: copying arguments into them allocates nothing if the
 * arguments are no larger than before. There are two, because the thread that executed the last call may not have
 * released it yet. Any thread; real-time safe except the first call.
 */
template <class Sent>
class SpareCalls {
public:
    SpareCalls() = default;
    ~SpareCalls() {
        for (auto& slot : slots_)
            if (Sent* const call = slot.load()) call->deref();
    }
    SpareCalls(const SpareCalls&) = delete;
    SpareCalls& operator=(const SpareCalls&) = delete;

    template <class... Args>
    typename Sent::shared_ptr take(CalleeBase* callee, Args&... args) {
        for (auto& slot : slots_) {
            const typename Sent::shared_ptr call(slot.exchange(nullptr), false);
            if (!call || call->callee() != callee) continue;
            if (call->begin(args...)) return call;
            give(call);
        }
        if (!used_.exchange(true)) give(new Sent(callee, args...));
        return new Sent(callee, args...);
    }
    /** For a call that has finished, or was never queued. */
    void give(typename Sent::shared_ptr call) {
        for (auto& slot : slots_) {
            Sent* empty = nullptr;
            if (slot.compare_exchange_strong(empty, call.get())) return static_cast<void>(call.detach());
        }
    }

private:
    std::atomic<Sent*> slots_[2] = {};
    std::atomic<bool> used_{false};
};

}  // namespace internal
}  // namespace RTT

#endif
