# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/flow/port_callbacks.cpp)
under_test(${file})
faulty_value(callbacks_relaxed_announcement ${file}
  [=[entry->round.fetch_or(1, @{std::memory_order_acq_rel}@) | 1;]=] [=[std::memory_order_relaxed]=])
faulty_value(callbacks_rely_on_an_announcement ${file}
  [=[return @{entry->queuedRound.load(std::memory_order_acquire)}@ == round ? 0 : round;]=]
  [=[entry->queuedRound.exchange(round)]=])
faulty_statement(callbacks_cleared_late ${file}
  [=[@{entry.round.fetch_add(1, std::memory_order_acq_rel);
    if (running || !entry.whileRunning.load(std::memory_order_relaxed)) entry.callback(port);}@]=]
  [=[entry.callback(port); entry.round.fetch_add(1);]=])
faulty_value(callbacks_rounds_repeat ${file} [=[else { @{entry.round.fetch_add(1, std::memory_order_acq_rel)}@;]=]
  [=[entry.round.fetch_sub(1)]=])
faulty_statement(callbacks_deleted_at_once ${file}
  [=[if (old) Reclaimer::retire(const_cast<Table*>(old), [](void* table) { delete static_cast<Table*>(table); });]=]
  [=[delete old;]=])
faulty_value(callbacks_relaxed_table ${file} [=[table_.store(next.release(), @{std::memory_order_release}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_statement(callbacks_not_waited_for ${file} [=[@{if (gone) waitFor(*gone, executesMessages);}@]=] [=[]=])
faulty_value(callbacks_removal_unseen ${file} [=[if (!entry_ || entry_->removed.load(@{std::memory_order_seq_cst}@)) return]=]
  [=[std::memory_order_relaxed]=])
faulty_value(callbacks_relaxed_end ${file} [=[entry_->executing.fetch_sub(1, @{std::memory_order_seq_cst}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(callbacks_wait_for_each_other ${file}
  [=[if (!executes() || @{Waiting::has(entry.thread.load(std::memory_order_relaxed))}@) return;]=] [=[false]=])
faulty_statement(callbacks_end_unheard ${file} [=[Waiting::mayBeOver();]=] [=[]=])
