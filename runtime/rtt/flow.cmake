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
    internal/ChannelArray.cpp
    internal/ConnFactory.cpp
    internal/ConnID.cpp
    internal/ConnectionManager.cpp
    internal/PortEndpoint.cpp
    internal/PortOperations.cpp
    internal/PortSources.cpp
    internal/DeferredCalls.cpp
    internal/Reclaimer.cpp
    internal/detail/waiting.cpp
    internal/SampleBox.cpp
    internal/SampleStore.cpp
    internal/SharedConnection.cpp
    internal/StorageCore.cpp
    internal/connection_create.cpp
    internal/connection_join.cpp
    internal/connection_stream.cpp
    internal/sample_type_name.cpp
    internal/detail/buffer_lock_free.cpp
    internal/detail/buffer_plain.cpp
    internal/detail/buffer_words.cpp
    internal/detail/data_counted.cpp
    internal/detail/data_plain.cpp
    internal/detail/data_versioned.cpp)
  target_sources(orocos-rtt PRIVATE ${CMAKE_CURRENT_LIST_DIR}/${source})
endforeach()
