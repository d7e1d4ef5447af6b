# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/flow/detail/buffer_words.cpp)
set(words rtt/internal/flow/detail/sample_words.hpp)
under_test(${file} ${words})
faulty_value(words_relaxed_words ${words}
  [=[sizeof word);
        to->store(word, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(words_relaxed_copy ${words} [=[from[w].load(@{std::memory_order_acquire}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(words_overwritten ${file}
  [=[if (@{!cell.compare_exchange_strong(word, pack(t, slot), std::memory_order_acq_rel)}@) continue;]=]
  [=[(cell.store(pack(t, slot)), false)]=])
faulty_value(words_relaxed_enter ${file}
  [=[(word, pack(t, slot), @{std::memory_order_acq_rel}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(words_taken_twice ${file}
  [=[return @{head_.compare_exchange_strong(h, h + 1, std::memory_order_acq_rel, std::memory_order_relaxed)}@;]=]
  [=[(head_.store(h + 1), true)]=])
faulty_value(words_relaxed_tail ${file}
  [=[tail_.store(t + 1, @{std::memory_order_release}@);  // W4]=] [=[std::memory_order_relaxed]=])
faulty_value(words_spare_kept ${file} [=[slot = @{slotOf(word)}@;]=] [=[slot]=])
faulty_value(words_old_not_checked ${file} [=[if (@{head_.load(std::memory_order_relaxed) != h}@) continue;]=] [=[false]=])
