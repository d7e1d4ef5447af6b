# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(depth 3)
set(threads 4)
include(${CMAKE_CURRENT_LIST_DIR}/small_presence.cmake)
set(queue rtt/engine_queue.cpp)
set(call rtt/internal/calls/sent_call.cpp)
set(step rtt/ExecutionEngine.cpp)
set(gate rtt/internal/engine/engine_gate.cpp)
under_test(${queue} ${call} ${step} ${gate})
faulty_value(call_relaxed_state ${call} [=[if (@{state_.exchange(state)}@ & kParked)]=]
  [=[state_.exchange(state, std::memory_order_relaxed)]=])
faulty_value(call_sleeps_for_ever ${call}
  [=[os::detail::futexWait(state_, @{Waiting | kParked}@, OtherOrder::limit(os::detail::kForever));]=]
  [=[static_cast<std::uint32_t>(state_.load(std::memory_order_relaxed))]=])
faulty_value(call_relaxed_deref ${call}
  [=[if (references_.fetch_sub(1, @{std::memory_order_acq_rel}@) == 1) delete this;]=] [=[std::memory_order_relaxed]=])
faulty_statement(engine_not_notified ${queue} [=[        @{gate_->waitPoint.notify();}@
    if (!accepts() || gate_->retired())]=] [=[static_cast<void>(0);]=])
faulty_value(engine_state_not_asked_again ${queue} [=[if (@{!accepts()}@ || gate_->retired()) {
        disposeQueued();]=] [=[false]=])
faulty_value(gate_visitors_ignored ${gate} [=[if (@{over()}@) return true;]=] [=[true]=])
faulty_statement(gate_closed_late ${gate} [=[    @{offered_.store(nullptr);
    engine_.store(nullptr);
    activity_.store(nullptr);
    waitForVisitors();}@]=] [=[waitForVisitors(); offered_.store(nullptr); engine_.store(nullptr); activity_.store(nullptr);]=])
faulty_statement(gate_retired_late ${step} [=[    @{gate.retire();
    gate_->waitPoint.notify();
    disposeQueued();
    return gate.waitUntilLeft(deadline);}@]=] [=[const bool left = gate.waitUntilLeft(deadline); gate.retire(); disposeQueued(); return left;]=])
faulty_value(engine_retired_not_asked_again ${queue} [=[ || @{gate_->retired()}@) {
        disposeQueued();]=] [=[false]=])
faulty_statement(engine_start_not_marked ${step} [=[@{gate_->waitPoint.mark();}@
    if (hasWork())]=] [=[static_cast<void>(0);]=])
faulty_value(engine_start_forgets ${step} [=[if (@{hasWork()}@) activity->trigger();]=] [=[false]=])
