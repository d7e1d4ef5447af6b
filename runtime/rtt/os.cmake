# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Operating system layer, activities and logger.
target_sources(orocos-rtt PRIVATE
  rtt/Activity.cpp
  rtt/Logger.cpp
  rtt/base/ActivityInterface.cpp
  rtt/base/RunnableInterface.cpp
  rtt/detail/log_claim.cpp
  rtt/detail/log_clock.cpp
  rtt/detail/log_colors.cpp
  rtt/detail/log_drain.cpp
  rtt/detail/log_file.cpp
  rtt/detail/log_format.cpp
  rtt/detail/log_leftovers.cpp
  rtt/detail/log_line.cpp
  rtt/detail/log_queue.cpp
  rtt/detail/log_observers.cpp
  rtt/detail/log_relay.cpp
  rtt/detail/log_settings.cpp
  rtt/detail/log_sink.cpp
  rtt/detail/oro_main.cpp
  rtt/extras/FileDescriptorActivity.cpp
  rtt/extras/FileDescriptorSimulationActivity.cpp
  rtt/extras/PeriodicActivity.cpp
  rtt/extras/SequentialActivity.cpp
  rtt/extras/SimulationActivity.cpp
  rtt/extras/SimulationThread.cpp
  rtt/extras/TimerThread.cpp
  rtt/extras/detail/poll_set.cpp
  rtt/internal/engine/deferred_activity.cpp
  rtt/os/Condition.cpp
  rtt/os/MainThread.cpp
  rtt/os/Mutex.cpp
  rtt/os/SignalCatcher.cpp
  rtt/os/StartStopManager.cpp
  rtt/os/Thread.cpp
  rtt/os/ThreadInterface.cpp
  rtt/os/ThreadSession.cpp
  rtt/os/ThreadStartStop.cpp
  rtt/os/TimeService.cpp
  rtt/os/Timer.cpp
  rtt/os/detail/memory_check.cpp
  rtt/os/detail/memory_pool.cpp
  rtt/os/os_log.cpp
  rtt/os/detail/pool_registry.cpp
  rtt/os/detail/scheduling.cpp
  rtt/os/oro_malloc.cpp
  rtt/os/real_time_wanted.cpp
  rtt/os/startstop.cpp
  rtt/os/threads.cpp)
# `deployer --rt-check` recognises real-time memory by the names of its functions: the compiler must not divide them into parts
# without names.
set_source_files_properties(rtt/os/detail/memory_pool.cpp PROPERTIES COMPILE_OPTIONS -fsemantic-interposition)
