# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(depth 1)
set(threads 4)
include(${CMAKE_CURRENT_LIST_DIR}/small_presence.cmake)
set(file rtt/internal/engine/access_gate.cpp)
set(header rtt/internal/engine/access_gate.hpp)
under_test(${file} ${header})
faulty_value(access_not_refused ${header} [=[if (@{!gate.closed_}@) return &place;]=] [=[true]=])
faulty_statement(access_not_waited_for ${file}
  [=[    @{Presence::Waiter(this).wait(os::detail::kForever);}@]=] [=[]=])
faulty_statement(access_closed_late ${file} [=[    @{closed_ = true;}@]=] [=[Presence::Waiter(this).wait(os::detail::kForever); closed_ = true; return;]=])
