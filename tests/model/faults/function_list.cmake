# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(header rtt/internal/engine/function_list.hpp)
set(file rtt/internal/engine/function_list.cpp)
under_test(${header} ${file})
set(wake [=[wakes_.fetch_add(1, std::memory_order_release);]=])
faulty_statement(functions_relaxed_wake ${header} "${wake}" [=[wakes_.fetch_add(1, std::memory_order_relaxed);]=])
faulty_statement(functions_not_woken ${header} "else { @{${wake}}@" [=[static_cast<void>(0);]=])
faulty_value(functions_relaxed_take ${header} [=[wakes_.load(@{std::memory_order_acquire}@);
        if]=] [=[std::memory_order_relaxed]=])
# The count that is remembered is one that came after the functions were asked.
faulty_statement(functions_seen_too_late ${file} [=[if (all_[i] && !isDue(i) && !all_[i]->isIdle()) setDue(i, true);]=]
  [=[if (all_[i] && !isDue(i) && !all_[i]->isIdle()) setDue(i, true);
     seen_ = wakes_.load();]=])
