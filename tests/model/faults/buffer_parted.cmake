# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(part rtt/internal/flow/detail/buffer_lock_free.cpp)
set(file rtt/internal/flow/detail/buffer_parted.cpp)
under_test(${part})
under_test(${file})
faulty_value(parted_not_looked_again ${file} [=[better = @{true}@;]=] [=[false]=])
faulty_value(parted_refused_too_soon ${file} [=[if (@{takenOut() == before}@) return drop();]=] [=[true]=])
faulty_value(parted_other_parts_not_tried ${file} [=[for (std::size_t i = 0; i < @{count_}@; ++i)
                if (parts_[(own]=] [=[1]=])
faulty_value(parted_relaxed_enter ${part}
  [=[(word, pack(t, slot), @{std::memory_order_acq_rel}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(parted_taken_twice ${part}
  [=[return @{head_.compare_exchange_strong(h, h + 1, std::memory_order_acq_rel)}@; }  // R1]=] [=[(head_.store(h + 1), true)]=])
