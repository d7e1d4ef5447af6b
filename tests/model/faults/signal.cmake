# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/SignalBase.cpp)
under_test(${file})
faulty_statement(signal_freed_at_once ${file} [=[@{Reclaimer::retire(const_cast<List*>(previous),
                          [](void* list) { intrusive_ptr_release(static_cast<const List*>(list)); });}@]=]
  [=[intrusive_ptr_release(previous);]=])
faulty_value(signal_relaxed_list ${file} [=[nullptr : next.release(), @{std::memory_order_release}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(signal_relaxed_release ${file}
  [=[if (list->references.fetch_sub(1, @{std::memory_order_acq_rel}@) == 1)]=] [=[std::memory_order_relaxed]=])
