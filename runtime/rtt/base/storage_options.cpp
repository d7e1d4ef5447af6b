// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/BufferBase.hpp>
#include <rtt/base/DataObjectBase.hpp>

#include <rtt/ConnPolicy.hpp>

namespace RTT::base {

StorageUsers::StorageUsers(const ConnPolicy& policy)
    : max_threads_(policy.max_threads > 0 ? static_cast<unsigned int>(policy.max_threads) : 0),
      several_writers_(policy.buffer_policy == PerInputPort || policy.buffer_policy == Shared),
      several_readers_(policy.buffer_policy == PerOutputPort || policy.buffer_policy == Shared) {}

DataObjectBase::~DataObjectBase() = default;
DataObjectBase::Options::Options(const ConnPolicy& policy) : StorageUsers(policy) {}

BufferBase::~BufferBase() = default;
BufferBase::Options::Options(const ConnPolicy& policy)
    : StorageUsers(policy), circular_(policy.type == ConnPolicy::CIRCULAR_BUFFER) {}

}  // namespace RTT::base
