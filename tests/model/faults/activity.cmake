# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(depth 1)
set(threads 4)
include(${CMAKE_CURRENT_LIST_DIR}/small_presence.cmake)
set(activity rtt/Activity.cpp)
set(session rtt/os/ThreadSession.cpp)
under_test(${activity} ${session})
faulty_value(activity_early_timeout_lost ${session} [=[return @{reasons & ~(kFirstOwnReason - 1)}@;]=] [=[0u]=])
faulty_value(activity_start_executes_nothing ${activity}
  [=[std::uint32_t reasons = @{takeEarlyReasons() | kTrigger | kNewPeriod}@;]=] [=[takeEarlyReasons() | kNewPeriod]=])
faulty_value(activity_looks_then_sleeps ${activity}
  [=[reasons = @{waitForWake(wakeUp)}@;]=] [=[(state_->wakeWord.word_.store(0), waitForWake(wakeUp))]=])
faulty_value(activity_timeout_hides_trigger ${activity} [=[if (@{reasons & kTrigger}@) {]=]
  [=[(reasons & kTrigger) && !(reasons & kTimeout)]=])
