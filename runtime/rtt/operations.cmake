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
  ${CMAKE_CURRENT_LIST_DIR}/internal/CallPool.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/CallSource.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/Callee.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/FailureReport.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/detail/diagnostic_taker.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/GlobalEngine.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/GlobalService.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/Interruption.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/OperationCallerC.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/OperationPart.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/OperationSignature.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/PortCallbacks.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/RemoteOperation.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/SendHandleC.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/SentCall.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/ServiceLoader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/SignalBase.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/WaitPoint.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/detail/action_slot.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/detail/call_handles.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/detail/part_send.cpp
  ${CMAKE_CURRENT_LIST_DIR}/internal/detail/remote_values.cpp)
# Each step of a component goes through these. A compiler that sees them at once halves what an empty step costs.
oroforge_unit(orocos-rtt rtt_step ${PROJECT_SOURCE_DIR}/runtime
  rtt/ExecutionEngine.cpp
  rtt/base/TaskCore.cpp
  rtt/extras/SlaveActivity.cpp
  rtt/internal/AccessGate.cpp
  rtt/internal/EngineGate.cpp
  rtt/internal/FunctionList.cpp
  rtt/internal/HookInProgress.cpp
  rtt/internal/Mailbox.cpp
  rtt/internal/Presence.cpp)
