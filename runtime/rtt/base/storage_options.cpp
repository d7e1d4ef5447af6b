// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/BufferBase.hpp>
#include <rtt/base/DataObjectBase.hpp>

#include <rtt/ConnPolicy.hpp>

namespace RTT {
namespace base {

namespace {
unsigned int threadsOf(const ConnPolicy& policy) {
    return policy.max_threads > 0 ? static_cast<unsigned int>(policy.max_threads) : 2;
}
}  // namespace

DataObjectBase::~DataObjectBase() = default;
DataObjectBase::Options::Options(const ConnPolicy& policy) : max_threads_(threadsOf(policy)) {}

BufferBase::~BufferBase() = default;
BufferBase::Options::Options(const ConnPolicy& policy)
    : circular_(policy.type == ConnPolicy::CIRCULAR_BUFFER), max_threads_(threadsOf(policy)) {}

}  // namespace base
}  // namespace RTT
