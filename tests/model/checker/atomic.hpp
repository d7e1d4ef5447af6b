// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Stand-ins for std::atomic, std::mutex and plain variables, all of whose operations the checker sees.
#ifndef OROFORGE_MODEL_ATOMIC_HPP
#define OROFORGE_MODEL_ATOMIC_HPP

#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace model {

/** Ties an object to the checker's record of it, anew in each run. */
struct Handle {
    std::uint32_t run = 0, index = 0;
};

// Values travel as 64-bit words. `initial` is the value the object was constructed with; statics have it again in each run.
std::uint64_t atomicLoad(const void* at, Handle& handle, std::uint64_t initial, std::memory_order order);
void atomicStore(const void* at, Handle& handle, std::uint64_t& initial, std::uint64_t value, std::memory_order order);
enum class Change { Exchange, Add, Sub, And, Or, Xor };
std::uint64_t atomicChange(const void* at, Handle& handle, std::uint64_t& initial, Change change, std::uint64_t operand,
                           std::uint64_t mask, std::memory_order order);
bool atomicCompareExchange(const void* at, Handle& handle, std::uint64_t& initial, std::uint64_t& expected,
                           std::uint64_t desired, std::memory_order success, std::memory_order failure);
void atomicCreate(const void* at, Handle& handle, std::uint64_t initial);
void atomicDestroy(const void* at, Handle& handle, std::uint64_t initial);

constexpr std::memory_order failureOrder(std::memory_order success) {
    return success == std::memory_order_acq_rel   ? std::memory_order_acquire
           : success == std::memory_order_release ? std::memory_order_relaxed
                                                  : success;
}

template <class T>
class Atomic {
    static_assert(std::is_trivially_copyable<T>::value && sizeof(T) <= 8, "kept in a word");
    typedef std::memory_order Order;
    static constexpr Order kSeq = std::memory_order_seq_cst;

public:
    constexpr Atomic() noexcept : Atomic(T()) {}
    constexpr Atomic(T value) noexcept : initial_(word(value)) {
        if (!__builtin_is_constant_evaluated()) atomicCreate(this, handle_, initial_);
    }
    ~Atomic() { atomicDestroy(this, handle_, initial_); }
    Atomic(const Atomic&) = delete;
    Atomic& operator=(const Atomic&) = delete;

    T load(Order order = kSeq) const { return value(atomicLoad(this, handle_, initial_, order)); }
    void store(T v, Order order = kSeq) { atomicStore(this, handle_, initial_, word(v), order); }
    T exchange(T v, Order order = kSeq) { return change(Change::Exchange, v, order); }
    bool compare_exchange_strong(T& expected, T desired, Order success, Order failure) {
        std::uint64_t old = word(expected);
        const bool done = atomicCompareExchange(this, handle_, initial_, old, word(desired), success, failure);
        if (!done) expected = value(old);
        return done;
    }
    bool compare_exchange_strong(T& expected, T desired, Order order = kSeq) {
        return compare_exchange_strong(expected, desired, order, failureOrder(order));
    }
    bool compare_exchange_weak(T& expected, T desired, Order success, Order failure) {
        return compare_exchange_strong(expected, desired, success, failure);
    }
    bool compare_exchange_weak(T& expected, T desired, Order order = kSeq) {
        return compare_exchange_strong(expected, desired, order);
    }
    T fetch_add(T v, Order order = kSeq) { return change(Change::Add, v, order); }
    T fetch_sub(T v, Order order = kSeq) { return change(Change::Sub, v, order); }
    T fetch_and(T v, Order order = kSeq) { return change(Change::And, v, order); }
    T fetch_or(T v, Order order = kSeq) { return change(Change::Or, v, order); }
    T fetch_xor(T v, Order order = kSeq) { return change(Change::Xor, v, order); }
    operator T() const { return load(); }
    T operator=(T v) {
        store(v);
        return v;
    }
    T operator++() { return static_cast<T>(fetch_add(1) + 1); }
    T operator--() { return static_cast<T>(fetch_sub(1) - 1); }

    /** For the futex, which is no access of the program. */
    Handle& handle() const { return handle_; }
    std::uint64_t initial() const { return initial_; }

private:
    static constexpr std::uint64_t mask() {
        return sizeof(T) == 8 ? ~std::uint64_t(0) : (std::uint64_t(1) << (8 * sizeof(T) % 64)) - 1;
    }
    static constexpr std::uint64_t word(T v) {
        if constexpr (std::is_integral<T>::value || std::is_enum<T>::value) {
            return static_cast<std::uint64_t>(v) & mask();
        } else if constexpr (std::is_pointer<T>::value) {
            return v == nullptr ? 0 : reinterpret_cast<std::uint64_t>(v);
        } else {
            std::uint64_t w = 0;
            std::memcpy(&w, &v, sizeof v);
            return w;
        }
    }
    static T value(std::uint64_t w) {
        T v;
        std::memcpy(&v, &w, sizeof v);  // little-endian, as all machines that tests run on
        return v;
    }
    T change(Change what, T operand, Order order) {
        return value(atomicChange(this, handle_, initial_, what, word(operand), mask(), order));
    }

    mutable std::uint64_t initial_;
    mutable Handle handle_;
};

class Mutex {
public:
    constexpr Mutex() noexcept = default;
    Mutex(const Mutex&) = delete;
    Mutex& operator=(const Mutex&) = delete;
    void lock();
    void unlock();

private:
    Handle handle_;
};

void plainRead(const void* at, Handle& handle);
void plainWrite(const void* at, Handle& handle);

/** A plain variable: fails the run if two threads use it at the same time and one changes it. */
template <class T>
class Plain {
public:
    Plain() { plainWrite(this, handle_); }
    Plain(const T& value) : value_(value) { plainWrite(this, handle_); }
    Plain(const Plain& other) : value_(other.get()) { plainWrite(this, handle_); }
    ~Plain() { plainWrite(this, handle_); }
    Plain& operator=(const Plain& other) { return *this = other.get(); }
    Plain& operator=(const T& value) {
        plainWrite(this, handle_);
        value_ = value;
        return *this;
    }
    operator T() const { return get(); }
    T get() const {
        plainRead(this, handle_);
        return value_;
    }

private:
    T value_{};
    mutable Handle handle_;
};

/** Sleeps until another thread has stored something: what a loop does that waits by sleeping or yielding. */
void yield();
/** membarrier(2): whatever was executed before it is visible to all that is executed after it. Orders no plain variables. */
void membarrier();
bool futexWait(const Atomic<std::uint32_t>& word, std::uint32_t expected);
void futexWake(const Atomic<std::uint32_t>& word, unsigned count);

/** Reference count of a shared object: synchronises as one does, without steps of its own. */
class Count {
public:
    void add();
    /** True for the last one. */
    bool drop();

private:
    unsigned long count_ = 1;
    Handle handle_;
};

}  // namespace model

#endif
