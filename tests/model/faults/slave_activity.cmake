# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(depth 2)
set(threads 3)
include(${CMAKE_CURRENT_LIST_DIR}/small_presence.cmake)
set(file rtt/extras/SlaveActivity.cpp)
under_test(${file})
faulty_value(slave_relaxed_claim ${file} [=[if (queued_.exchange(true, @{std::memory_order_acq_rel}@)) return false;]=]
  [=[std::memory_order_relaxed]=])
faulty_statement(slave_unqueued_late ${file}
  [=[        @{queued_.exchange(false, std::memory_order_acq_rel);
        const Owner atEnd{*this};  // even if the component throws
        os::MutexLock lock(mutex_);
        if (slave_) slave_->executeTrigger();}@]=]
  [=[const Owner atEnd{*this}; os::MutexLock lock(mutex_); if (slave_) slave_->executeTrigger(); queued_.exchange(false);]=])
faulty_statement(slave_trigger_not_served ${file} [=[        if (active) executeOnce();
    }
    @{if (pending_) servePending();}@]=] [=[static_cast<void>(0);]=])
faulty_value(slave_two_execute ${file} [=[if (@{internal::Presence::Waiter(this).others()}@) {]=] [=[false]=])
faulty_value(slave_owner_not_asked_again ${file} [=[if (place && @{owner_ != self}@) {]=] [=[false]=])
faulty_value(slave_owner_stays ${file} [=[const int last = @{owner_.exchange(0)}@;]=] [=[owner_.load()]=])
