# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/flow/reclaimer.cpp)
set(header rtt/internal/flow/reclaimer.hpp)
under_test(${file} ${header})
adapt(${file} [=[kPool = 64;]=] [=[kPool = 4;]=])
faulty_value(reclaimer_no_barrier ${file} [=[if (@{!asymmetric}@) return;]=] [=[true]=])
faulty_value(reclaimer_too_early ${file} [=[if (@{one.epoch < oldest}@)]=] [=[one.epoch <= oldest]=])
faulty_value(reclaimer_relaxed_look ${file}
  [=[r->epoch.load(@{std::memory_order_seq_cst}@);
            if (epoch != 0]=] [=[std::memory_order_relaxed]=])
faulty_value(reclaimer_waiters_forgotten ${file} [=[&& @{!record.waiting.load(std::memory_order_seq_cst)}@;]=] [=[true]=])
faulty_value(reclaimer_relaxed_synchronize ${file}
  [=[const std::uint64_t inside = record.epoch.load(@{std::memory_order_seq_cst}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(reclaimer_relaxed_leave ${header}
  [=[record.epoch.store(0, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(reclaimer_relaxed_enter ${header}
  [=[record.epoch.store(epoch_.load(@{std::memory_order_acquire}@), ]=] [=[std::memory_order_relaxed]=])
faulty_value(reclaimer_relaxed_return ${header} [=[), @{std::memory_order_release}@);
    }
    static void leave]=] [=[std::memory_order_relaxed]=])
faulty_statement(reclaimer_end_unheard ${header} [=[@{if (__builtin_expect(static_cast<unsigned>(!record.deferred.empty()) | record.awaited, 0)) afterwards(record);}@]=]
  [=[]=])
faulty_statement(reclaimer_no_barrier_before_sleep ${file} [=[awaited.fetch_add(1);
        @{barrier();}@]=] [=[]=])
faulty_value(reclaimer_relaxed_fence ${file} [=[epoch_.fetch_add(0, @{std::memory_order_acq_rel}@);]=]
  [=[std::memory_order_relaxed]=])
