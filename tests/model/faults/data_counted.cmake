# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/flow/detail/data_counted.cpp)
under_test(${file})
faulty_value(counted_no_second_look ${file}
  [=[if (@{current_.load(std::memory_order_acquire) == c}@)]=] [=[true]=])
faulty_value(counted_readers_ignored ${file} [=[(now & ~kUnread) == 0]=] [=[(now & kHeld) == 0]=])
faulty_value(counted_relaxed_claim ${file}
  [=[now, kHeld | kUnread, @{std::memory_order_acquire}@,]=] [=[std::memory_order_relaxed]=])
faulty_value(counted_relaxed_publication ${file}
  [=[current_.exchange(i, @{std::memory_order_acq_rel}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(counted_relaxed_unhold ${file}
  [=[state(i).fetch_and(~kHeld, @{std::memory_order_release}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(counted_relaxed_visit ${file}
  [=[s.fetch_add(1, @{std::memory_order_acq_rel}@);]=] [=[std::memory_order_relaxed]=])
faulty_value(counted_relaxed_leave ${file}
  [=[(now - 1) & ~kUnread, @{std::memory_order_acq_rel}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(counted_new_twice ${file} [=[return @{now & kUnread}@ ? NewData : OldData;]=] [=[true]=])
faulty_value(counted_relaxed_turn ${file}
  [=[header(i).turn.load(std::memory_order_relaxed) + 1, @{std::memory_order_release}@)]=] [=[std::memory_order_relaxed]=])
faulty_value(counted_turn_without_look ${file}
  [=[if (@{c == current_.load(std::memory_order_acquire)}@)]=] [=[true]=])
