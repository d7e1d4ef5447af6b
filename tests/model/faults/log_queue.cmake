# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/detail/log_queue.cpp)
set(header rtt/detail/log_queue.hpp)
under_test(${file} ${header})
adapt(${header} [=[kCells = 512;]=] [=[kCells = 4;]=])
adapt(${header} [=[kRoom = 216;]=] [=[kRoom = 2;]=])
adapt(${header} [=[std::int64_t time;]=] [=[model::Plain<std::int64_t> time;]=])
faulty_value(log_queue_relaxed_put ${file}
  [=[first.sequence.store(position + 1, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(log_queue_relaxed_look ${file}
  [=[at(head_).sequence.load(@{std::memory_order_acquire}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(log_queue_relaxed_give ${file}
  [=[at(head_).sequence.store(head_ + kCells, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(log_queue_relaxed_win ${file}
  [=[at(last).sequence.load(@{std::memory_order_acquire}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(log_queue_put_over ${file}
  [=[if (@{tail_.compare_exchange_weak(position, position + count, std::memory_order_relaxed)}@)]=]
  [=[(tail_.store(position + count), true)]=])
faulty_value(log_queue_first_cell_only ${file} [=[const std::uint32_t last = position + @{count - 1}@;]=] [=[0]=])
