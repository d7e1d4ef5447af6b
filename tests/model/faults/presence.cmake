# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/engine/presence.cpp)
set(header rtt/internal/engine/presence.hpp)
under_test(${file} ${header})
adapt(${file} [=[ThreadRecords<Record, 64>]=] [=[ThreadRecords<Record, 4>]=])
adapt(${header} [=[kDepth = 11;]=] [=[kDepth = 2;]=])
faulty_statement(presence_waits_without_attention ${file} [=[waiters.fetch_add(1);
    @{attention_.fetch_add(1);}@]=] [=[]=])
faulty_value(presence_no_barrier ${file} [=[if (@{State::asymmetric}@) detail::processBarrier();]=] [=[false]=])
faulty_statement(presence_relaxed_without_membarrier ${file} [=[@{place.exchange(word);}@]=]
  [=[place.store(word, std::memory_order_release);]=])
faulty_statement(presence_end_relaxed_without_membarrier ${file} [=[@{place.exchange(0);}@]=] [=[]=])
faulty_value(presence_relaxed_leave ${header} [=[place.store(0, @{std::memory_order_release}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(presence_relaxed_enter ${header} [=[(what), @{std::memory_order_release}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(presence_end_not_told ${header} [=[if (__builtin_expect(@{attention_ != 0}@, 0))]=] [=[false]=])
faulty_value(presence_no_ring ${file} [=[if (@{bell.waiters != 0}@)]=] [=[false]=])
faulty_statement(presence_waits_unseen ${file} [=[    @{bellOf(what_).waiters.fetch_add(1);}@]=] [=[]=])
faulty_statement(presence_one_woken ${file} [=[    @{os::detail::futexWakeAll(bell.rings);}@]=]
  [=[os::detail::futexWakeOne(bell.rings);]=])
faulty_value(presence_one_record_looked_at ${file} [=[record = @{record->next}@) {]=] [=[static_cast<Record*>(nullptr)]=])
faulty_statement(presence_forgotten_silently ${file} [=[    @{ring(bellOf(reinterpret_cast<std::uintptr_t>(what)));}@]=] [=[]=])
faulty_value(presence_forgotten_is_free ${file} [=[place.store(@{kForgotten}@, std::memory_order_release)]=] [=[std::uintptr_t(0)]=])
