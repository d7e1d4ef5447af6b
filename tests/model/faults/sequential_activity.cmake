# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(depth 1)
set(threads 4)
include(${CMAKE_CURRENT_LIST_DIR}/small_presence.cmake)
set(file rtt/extras/SequentialActivity.cpp)
under_test(${file})
faulty_value(sequential_leaves_too_early ${file} [=[if (@{!requests_.compare_exchange_strong(seen, 0)}@) {]=]
  [=[(requests_.store(0), false)]=])
faulty_value(sequential_relaxed_trigger ${file} [=[if (@{requests_.fetch_add(1)}@ == 0)]=]
  [=[requests_.fetch_add(1, std::memory_order_relaxed)]=])
faulty_value(sequential_not_woken ${file} [=[if (@{before & kWaiting}@)]=] [=[false]=])
faulty_value(sequential_stop_does_not_wait ${file} [=[while (@{requests != 0}@) {
        // The mark]=] [=[false]=])
faulty_value(sequential_direct_beside_execution ${file}
  [=[if (@{!requests_.compare_exchange_strong(nobody, 1)}@) return Direct::Refused;]=] [=[(requests_.store(1), false)]=])
