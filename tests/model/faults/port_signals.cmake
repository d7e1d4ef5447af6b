# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/base/input_port_signals.cpp)
under_test(${file})
faulty_value(signals_relaxed_pin ${file} [=[pinned_.fetch_add(1, @{std::memory_order_seq_cst}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(signals_relaxed_end ${file} [=[pinned_.fetch_sub(1, @{std::memory_order_release}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(signals_not_waited_for ${file} [=[while (@{pinned_.load(std::memory_order_seq_cst) > own}@)]=] [=[false]=])
