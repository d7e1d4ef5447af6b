# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/os/detail/wake_word.hpp)
under_test(${file})
set(post [=[if (word_.fetch_or(reasons, std::memory_order_release) == kSleeping) futexWakeOne(word_);]=])
faulty_statement(wake_more_than_once ${file} "${post}"
  [=[if (word_.fetch_or(reasons, std::memory_order_release) & kSleeping) futexWakeOne(word_);]=])
faulty_statement(wake_relaxed_post ${file} "else { @{${post}}@"
  [=[if (word_.fetch_or(reasons, std::memory_order_relaxed) == kSleeping) futexWakeOne(word_);]=])
faulty_statement(wake_post_left_out ${file} "else { @{${post}}@"
  [=[if ((word_.load() & reasons) == 0 && word_.fetch_or(reasons) == kSleeping) futexWakeOne(word_);]=])
faulty_value(wake_sleeps_over_reasons ${file}
  [=[word_.compare_exchange_strong(nothing, kSleeping, std::memory_order_relaxed)]=]
  [=[(word_.store(kSleeping), true)]=])
faulty_value(wake_relaxed_take ${file}
  [=[word_.exchange(0, @{std::memory_order_acquire}@)]=] [=[std::memory_order_relaxed]=])
