// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A sent call with its arguments and its result. It has a tuple and an optional of its own, which cost the compiler a
// fraction of the standard ones: they are instantiated for every operation of every component.
#ifndef ORO_INTERNAL_TYPED_CALL_HPP
#define ORO_INTERNAL_TYPED_CALL_HPP

#include <rtt/internal/calls/sent_call.hpp>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace RTT {
namespace internal {

/** True for arguments that an operation changes for its caller. */
template <class Arg>
constexpr bool isOutput = std::is_lvalue_reference_v<Arg> && !std::is_const_v<std::remove_reference_t<Arg>>;
template <class Arg>
using ValueOf = std::remove_cv_t<std::remove_reference_t<Arg>>;

/** Holds the result of a function: a value, the address that a reference refers to, or nothing. */
template <class R>
class ResultStore {
public:
    ResultStore() = default;
    ~ResultStore() { clear(); }
    ResultStore(const ResultStore&) = delete;
    ResultStore& operator=(const ResultStore&) = delete;
    template <class F>
    void take(F&& f) {
        clear();
        ::new (bytes_) R(f());
        full_ = true;
    }
    const R& get() const { return *std::launder(reinterpret_cast<const R*>(bytes_)); }
    const void* address() const { return full_ ? bytes_ : nullptr; }

private:
    void clear() {
        if (full_) get().~R();
        full_ = false;
    }
    alignas(R) unsigned char bytes_[sizeof(R)];
    bool full_ = false;
};
template <class R>
class ResultStore<R&> {
public:
    template <class F>
    void take(F&& f) {
        value_ = std::addressof(f());
    }
    R& get() const { return *value_; }
    const void* address() const { return value_; }

private:
    R* value_ = nullptr;
};
template <>
class ResultStore<void> {
public:
    template <class F>
    void take(F&& f) {
        f();
    }
    void get() const {}
    const void* address() const { return nullptr; }
};

/** A copy of an argument; the position makes the type unique. */
template <std::size_t, class T>
struct Argument {
    T value;
};
template <class Indices, class... T>
struct ArgumentPack;
template <std::size_t... I, class... T>
struct ArgumentPack<std::index_sequence<I...>, T...> : Argument<I, T>... {
    explicit ArgumentPack(const T&... values) : Argument<I, T>{values}... {}
};
template <std::size_t I, class T>
T& argumentAt(Argument<I, T>& argument) {
    return argument.value;
}

template <class Signature>
class CallValues;
/** A call with copies of its arguments and room for its result, without the code that executes it. */
template <class R, class... Args>
class CallValues<R(Args...)> : public SentCall {
public:
    typedef boost::intrusive_ptr<CallValues> shared_ptr;

    explicit CallValues(CalleeBase* callee, const std::remove_reference_t<Args>&... args)
        : SentCall(callee), arguments(args...) {}
    const void* resultAddress() const override { return result.address(); }
    void* argumentAddress(unsigned index) override { return addressAt(index, std::index_sequence_for<Args...>()); }

    ArgumentPack<std::index_sequence_for<Args...>, ValueOf<Args>...> arguments;
    ResultStore<R> result;

private:
    template <std::size_t... I>
    void* addressAt(unsigned index, std::index_sequence<I...>) {
        void* const all[] = {std::addressof(argumentAt<I>(arguments))..., nullptr};
        return all[index];
    }
};

template <class Signature>
class TypedCall;
template <class R, class... Args>
class TypedCall<R(Args...)> final : public CallValues<R(Args...)> {
public:
    typedef boost::intrusive_ptr<TypedCall> shared_ptr;
    using CallValues<R(Args...)>::CallValues;

    /** Reuses the call with other arguments; false if another reference to it exists. */
    bool begin(const std::remove_reference_t<Args>&... args) {
        return this->beginAgain() && (assign(std::index_sequence_for<Args...>(), args...), true);
    }

private:
    template <std::size_t... I>
    void assign(std::index_sequence<I...>, const std::remove_reference_t<Args>&... args) {
        (static_cast<void>(argumentAt<I>(this->arguments) = args), ...);
    }
    void run() override { runWith(std::index_sequence_for<Args...>()); }
    template <std::size_t... I>
    void runWith(std::index_sequence<I...>) {
        // Arguments by value are moved; only those by reference are read again.
        this->result.take([this]() -> R {
            return (*static_cast<Callee<R(Args...)>*>(this->callee()))(
                static_cast<Args&&>(argumentAt<I>(this->arguments))...);
        });
    }
};

}  // namespace internal
}  // namespace RTT

#endif
