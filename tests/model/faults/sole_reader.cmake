# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(header rtt/internal/flow/detail/sole_reader.hpp)
under_test(${header})
faulty_value(sole_not_asked_again ${header}
  [=[if (__builtin_expect(@{thread_.load(std::memory_order_relaxed) == me}@, 1)) return true;]=] [=[true]=])
faulty_statement(sole_without_barrier ${header} [=[        @{processBarrier();}@
        thread_.store(shared());]=] [=[]=])
faulty_statement(sole_shared_too_early ${header} [=[        const void* thread = thread_.load(std::memory_order_acquire);
        @{if (thread == shared()) return false;}@]=] [=[if (thread == shared() || thread == ending()) return false;]=])
faulty_value(sole_late_is_ignored ${header} [=[late_ = @{reading_.load(std::memory_order_acquire)}@;]=] [=[false]=])
faulty_value(sole_relaxed_end ${header} [=[                reader_.reading_.store(false, @{std::memory_order_release}@);]=]
  [=[std::memory_order_relaxed]=])
faulty_value(sole_inside_uncounted ${header} [=[ @{inside_.load() != 1}@)]=] [=[false]=])
