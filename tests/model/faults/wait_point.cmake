# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/engine/wait_point.cpp)
set(header rtt/internal/engine/wait_point.hpp)
under_test(${file} ${header})
faulty_value(wait_relaxed_notify ${header} [=[if (@{word_.fetch_add(kStep)}@ & kAsleep)]=]
  [=[word_.fetch_add(kStep, std::memory_order_relaxed)]=])
faulty_value(wait_relaxed_ticket ${header} [=[word_.load(@{std::memory_order_acquire}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(wait_sleeps_unseen ${file}
  [=[return @{word_.compare_exchange_strong(found, asleep) || found == asleep}@;]=] [=[true]=])
faulty_value(wait_one_woken ${file} [=[@{os::detail::futexWakeAll(word_)}@;]=] [=[os::detail::futexWakeOne(word_)]=])
faulty_value(wait_woken_twice ${file} [=[if (@{word_.fetch_and(~kAsleep) & kAsleep}@)]=] [=[(word_.fetch_and(~kAsleep), true)]=])
