# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Components, their engine, operations and services.
target_sources(orocos-rtt PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/ConfigurationInterface.cpp
  ${CMAKE_CURRENT_LIST_DIR}/FactoryExceptions.cpp
  ${CMAKE_CURRENT_LIST_DIR}/OperationCaller.cpp
  ${CMAKE_CURRENT_LIST_DIR}/OperationInterface.cpp
  ${CMAKE_CURRENT_LIST_DIR}/SendStatus.cpp
  ${CMAKE_CURRENT_LIST_DIR}/Service.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ServiceRequester.cpp
  ${CMAKE_CURRENT_LIST_DIR}/TaskContext.cpp
  ${CMAKE_CURRENT_LIST_DIR}/task_interface.cpp
  ${CMAKE_CURRENT_LIST_DIR}/task_peers.cpp
  ${CMAKE_CURRENT_LIST_DIR}/engine_queue.cpp
  ${CMAKE_CURRENT_LIST_DIR}/base/DisposableInterface.cpp
  ${CMAKE_CURRENT_LIST_DIR}/base/OperationBase.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/call_pool.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/call_source.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/callee.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/failure_report.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/diagnostic_taker.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/GlobalEngine.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/GlobalService.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/dotted_name.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/engine/interruption.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/OperationCallerC.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/operation_part.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/operation_signature.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/flow/port_callbacks.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/remote_operation.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/SendHandleC.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/sent_call.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/plugin_loading.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/SignalBase.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/engine/wait_point.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/detail/action_slot.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/detail/call_handles.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/detail/part_send.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/calls/detail/remote_values.cpp)
# Each step of a component goes through these. A compiler that sees them at once halves what an empty step costs.
oroforge_unit(orocos-rtt rtt_step ${PROJECT_SOURCE_DIR}/runtime
  rtt/ExecutionEngine.cpp
  rtt/base/TaskCore.cpp
  rtt/extras/SlaveActivity.cpp
  rtt/extras/slave_master.cpp
  rtt/internal/engine/access_gate.cpp
  rtt/internal/engine/detail/guarded_call.cpp
  rtt/internal/engine/engine_functions.cpp
  rtt/internal/engine/engine_gate.cpp
  rtt/internal/engine/other_order.cpp
  rtt/internal/engine/function_list.cpp
  rtt/internal/engine/hook_in_progress.cpp
  rtt/internal/engine/script_place.cpp
  rtt/internal/engine/state_changes.cpp
  rtt/internal/engine/mailbox.cpp
  rtt/internal/engine/presence.cpp)
