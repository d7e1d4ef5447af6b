# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/base/input_port_signals.cpp)
set(calls rtt/internal/flow/deferred_calls.hpp)
set(waiting rtt/internal/flow/detail/waiting.cpp)
under_test(${file} ${calls} ${waiting})
adapt(${calls} [=[kSpare = 16;]=] [=[kSpare = 1;]=])
adapt(${calls} [=[void* argument;
        Call* next;]=] [=[model::Plain<void*> argument;
        Call* next;]=])
faulty_value(signals_relaxed_pin ${file} [=[pinned_.fetch_add(1, @{std::memory_order_seq_cst}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(signals_relaxed_end ${file}
  [=[pinned_.compare_exchange_weak(now, again ? 1 : now - 1, @{std::memory_order_seq_cst}@,]=]
  [=[std::memory_order_acquire]=])
faulty_value(signals_not_waited_for ${file} [=[return pins == 0 || @{pins <= Waiting::making(this)}@;]=] [=[true]=])
faulty_value(signals_not_cancelled ${file} [=[unpinned(@{Waiting::cancel(this)}@);]=] [=[0]=])
faulty_value(signals_wait_for_each_other ${file} [=[unpinned(@{Waiting::takeOver(this)}@);]=] [=[0]=])
faulty_value(signals_not_taken_over_while_made ${waiting}
  [=[taken += one->calls_.cancel(&one->parked_, argument) + @{DeferredCalls::abandon(&one->parked_, argument)}@;]=]
  [=[0]=])
faulty_statement(signals_end_unheard ${file} [=[if (!again) @{Waiting::mayBeOver();}@  //]=] [=[]=])
faulty_statement(signals_waiting_unheard ${waiting} [=[if (number_.fetch_add(1) != 0) @{wakeAll();}@]=] [=[]=])
faulty_value(signals_place_used_twice ${file} [=[calls.add(@{(before & ~kAgain) == 0}@ ? &signal_ : nullptr,]=] [=[true]=])
faulty_value(signals_owed_and_forgotten ${file} [=[const bool again = @{now == (kAgain | 1)}@;]=] [=[false]=])
faulty_value(signals_relaxed_debt ${file}
  [=[MODEL_FAULT(signals_relaxed_end) ? (std::memory_order_acquire) : (@{std::memory_order_seq_cst}@)]=]
  [=[std::memory_order_release]=])
