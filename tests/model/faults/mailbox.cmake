# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/engine/mailbox.cpp)
set(header rtt/internal/engine/mailbox.hpp)
under_test(${file} ${header})
adapt(${header} [=[kCapacity = 128;]=] [=[kCapacity = 2;]=])
faulty_value(mailbox_relaxed_put ${file}
  [=[cell.sequence.store(position + 1, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(mailbox_relaxed_look ${file}
  [=[cell.sequence.load(@{std::memory_order_acquire}@);
        const auto lead = static_cast<std::int32_t>(sequence - (position + 1));]=] [=[std::memory_order_relaxed]=])
faulty_value(mailbox_taken_twice ${file}
  [=[if (@{head_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)}@)]=]
  [=[(head_.store(position + 1), true)]=])
faulty_value(mailbox_put_over ${file}
  [=[if (@{tail_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)}@)]=]
  [=[(tail_.store(position + 1), true)]=])
faulty_value(mailbox_withdrawn_and_taken ${file} [=[packed = @{cell.item.exchange(packed & kKindBits)}@;]=] [=[packed]=])
