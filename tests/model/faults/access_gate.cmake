# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/AccessGate.cpp)
under_test(${file})
faulty_statement(access_not_woken ${file} [=[void AccessGate::leave() noexcept {
    @{if (word_.fetch_sub(1) & kClosed) os::detail::futexWakeAll(word_);}@]=] [=[word_.fetch_sub(1);]=])
faulty_value(access_not_refused ${file} [=[if (@{!(word_.fetch_add(1) & kClosed)}@) return true;]=]
  [=[(word_.fetch_add(1), true)]=])
faulty_value(access_relaxed_leave ${file} [=[if (@{word_.fetch_sub(1)}@ & kClosed)]=]
  [=[word_.fetch_sub(1, std::memory_order_relaxed)]=])
faulty_value(access_not_waited_for ${file} [=[while (@{(word & ~kClosed) > mine}@)]=] [=[false]=])
