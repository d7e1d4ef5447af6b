# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Ports, connections and the storage between them.
foreach(source
    ConnPolicy.cpp
    DataFlowInterface.cpp
    FlowStatus.cpp
    base/ChannelElementBase.cpp
    base/InputPortInterface.cpp
    base/OutputPortInterface.cpp
    base/PortInterface.cpp
    base/input_port_signals.cpp
    base/storage_options.cpp
    internal/flow/channel_array.cpp
    internal/ConnFactory.cpp
    internal/ConnID.cpp
    internal/ConnectionManager.cpp
    internal/flow/port_endpoint.cpp
    internal/flow/port_object.cpp
    internal/flow/port_operations.cpp
    internal/flow/port_sources.cpp
    internal/flow/deferred_calls.cpp
    internal/flow/reclaimer.cpp
    internal/flow/detail/waiting.cpp
    internal/flow/sample_box.cpp
    internal/flow/sample_store.cpp
    internal/SharedConnection.cpp
    internal/flow/storage_core.cpp
    internal/flow/connection_create.cpp
    internal/flow/connection_facts.cpp
    internal/flow/connection_join.cpp
    internal/flow/connection_stream.cpp
    internal/flow/sample_type_name.cpp
    internal/flow/detail/buffer_lock_free.cpp
    internal/flow/detail/buffer_parted.cpp
    internal/flow/detail/buffer_plain.cpp
    internal/flow/detail/buffer_words.cpp
    internal/flow/detail/data_counted.cpp
    internal/flow/detail/data_plain.cpp
    internal/flow/detail/data_versioned.cpp)
  target_sources(orocos-rtt PRIVATE ${CMAKE_CURRENT_LIST_DIR}/${source})
endforeach()
