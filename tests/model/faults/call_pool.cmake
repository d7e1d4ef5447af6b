# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(file rtt/internal/calls/call_pool.cpp)
set(header rtt/internal/calls/call_pool.hpp)
under_test(${file} ${header})
adapt(${header} [=[kSmall = 256;]=] [=[kSmall = 2;]=])
adapt(${header} [=[kLarge = 64;]=] [=[kLarge = 1;]=])
faulty_value(pool_without_tag ${file} [=[return @{(((head >> 32) + 1) << 32)}@ | number;]=] [=[0]=])
faulty_value(pool_relaxed_take ${file} [=[head_.compare_exchange_weak(head, next, @{std::memory_order_acquire}@)]=]
  [=[std::memory_order_relaxed]=])
faulty_value(pool_relaxed_give ${file} [=[head_.compare_exchange_weak(head, next, @{std::memory_order_release}@)]=]
  [=[std::memory_order_relaxed]=])
faulty_value(pool_fresh_twice ${file}
  [=[if (@{fresh_.compare_exchange_weak(fresh, fresh + 1, std::memory_order_relaxed)}@)]=]
  [=[(fresh_.store(fresh + 1), true)]=])
