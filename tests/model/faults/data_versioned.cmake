# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/flow/detail/data_versioned.cpp)
set(words rtt/internal/flow/detail/sample_words.hpp)
under_test(${file} ${words})
faulty_value(versioned_no_second_look ${file}
  [=[if (@{slot.version.load(std::memory_order_relaxed) != version}@) continue;]=] [=[false]=])
faulty_value(versioned_relaxed_words ${words}
  [=[sizeof word);
        to->store(word, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(versioned_relaxed_copy ${words}
  [=[from[w].load(@{std::memory_order_acquire}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(versioned_relaxed_publication ${file}
  [=[current_.store(version << kSlotBits | i, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(versioned_current_overwritten ${file}
  [=[if (@{indexOf(current_.load(std::memory_order_acquire)) == i}@) {]=] [=[false]=])
faulty_value(versioned_relaxed_owner ${file}
  [=[slot.owner.store(0, @{std::memory_order_release}@);  // W5]=] [=[std::memory_order_relaxed]=])
faulty_value(versioned_new_twice ${file}
  [=[if (!alone) return @{read_.compare_exchange_strong(seen, current, std::memory_order_acq_rel)}@;]=]
  [=[(read_.store(current), true)]=])
faulty_statement(versioned_never_taken ${file} [=[        @{read_.store(current, std::memory_order_release);}@
        return true;]=] [=[]=])
faulty_value(versioned_home_not_in_turn ${file} [=[homeNext_ = @{homeNext_ + 1 < kHomeSlots ? homeNext_ + 1 : 0}@;]=] [=[0]=])
