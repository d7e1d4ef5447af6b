# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(session rtt/os/ThreadSession.cpp)
set(startstop rtt/os/ThreadStartStop.cpp)
under_test(${session} ${startstop})
faulty_statement(thread_start_woken_first ${startstop} [=[    state_->life = State::kActive;
    @{state_->session.fetch_or(State::kDue);
    wake(kStartReason);
    return true;}@
}

bool Thread::startAgain]=] [=[wake(kStartReason); state_->session.fetch_or(State::kDue); return true;]=])
faulty_statement(thread_end_not_told ${session} [=[@{detail::futexWakeAll(state_->session);}@
}

void Thread::session]=] [=[]=])
faulty_value(thread_stop_does_not_wait ${startstop} [=[if (@{!waitForSessionEnd(timeout)}@) {]=] [=[false]=])
faulty_value(thread_runs_after_stop ${session} [=[if (@{mayRun()}@) loop();]=] [=[true]=])
