# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/flow/detail/buffer_lock_free.cpp)
under_test(${file})
faulty_value(buffer_relaxed_take ${file}
  [=[ring_[p & ringMask_].load(@{std::memory_order_acquire}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(buffer_taken_twice ${file}
  [=[return @{head_.compare_exchange_strong(h, h + 1, std::memory_order_acq_rel)}@; }  // R1]=] [=[(head_.store(h + 1), true)]=])
faulty_value(buffer_overwritten ${file}
  [=[if (@{!cell.compare_exchange_strong(word, pack(t, slot), std::memory_order_acq_rel)}@) continue;]=]
  [=[(cell.store(pack(t, slot)), false)]=])
faulty_value(buffer_relaxed_enter ${file}
  [=[(word, pack(t, slot), @{std::memory_order_acq_rel}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(buffer_relaxed_release ${file}
  [=[count(slot).fetch_sub(1, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(buffer_relaxed_claim ${file}
  [=[count(slot).compare_exchange_strong(free, 1, @{std::memory_order_acquire}@, std::memory_order_relaxed)]=]
  [=[std::memory_order_relaxed]=])
faulty_value(buffer_last_not_checked ${file}
  [=[if (@{last_.load(std::memory_order_acquire) != last}@) return -1;]=] [=[false]=])
faulty_value(buffer_tail_not_helped ${file}
  [=[if (@{hasTurn(word, t)}@) tail_.compare_exchange_strong]=] [=[false]=])
