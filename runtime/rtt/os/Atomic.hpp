// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_ATOMIC_HPP
#define ORO_OS_ATOMIC_HPP

#include <rtt/os/oro_arch.h>
#include <rtt/rtt-config.h>

namespace RTT {
namespace os {

/** An integer that threads may change at the same time. Lock-free, real-time safe, sequentially consistent. */
class AtomicInt {
public:
    explicit AtomicInt(int value = 0) noexcept { set(value); }
    AtomicInt(const AtomicInt& other) noexcept { set(other.read()); }
    AtomicInt& operator=(const AtomicInt& other) noexcept {
        set(other.read());
        return *this;
    }

    int read() const noexcept { return oro_atomic_read(&value_); }
    void set(int n) noexcept { oro_atomic_set(&value_, n); }
    void add(int n) noexcept { oro_atomic_add(&value_, n); }
    void sub(int n) noexcept { oro_atomic_sub(&value_, n); }
    void inc() noexcept { oro_atomic_inc(&value_); }
    void dec() noexcept { oro_atomic_dec(&value_); }
    /** The `…_and_test` functions return true if the new value is zero. */
    bool inc_and_test() noexcept { return oro_atomic_inc_and_test(&value_) != 0; }
    bool dec_and_test() noexcept { return oro_atomic_dec_and_test(&value_) != 0; }
    bool sub_and_test(int n) noexcept { return oro_atomic_sub_and_test(n, &value_) != 0; }

private:
    oro_atomic_t value_;
};

}  // namespace os
}  // namespace RTT
#endif
