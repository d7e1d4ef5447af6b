// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Makes the parts of a connection, and checks policies.
#include <rtt/internal/ConnFactory.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/flow/buffer_parts.hpp>
#include <rtt/internal/flow/detail/stores.hpp>

namespace RTT::internal {

ConnFactory::~ConnFactory() = default;

ConnFactory::ElementPtr ConnFactory::buildChannelOutput(base::InputPortInterface& port,
                                                        ConnPolicy const& policy) const {
    return makeChannelOutput(port, policy);
}

ConnFactory::ElementPtr ConnFactory::buildChannelInput(base::OutputPortInterface& port,
                                                       ConnPolicy const& policy) const {
    return makeChannelInput(port, policy);
}

ConnFactory::ElementPtr ConnFactory::makeChannelOutput(base::InputPortInterface& port, ConnPolicy const& policy) {
    const ElementPtr storage = port.buildStorage(policy);
    if (storage) storage->connectTo(ElementPtr(port.getEndpoint()));
    return storage;
}

ConnFactory::ElementPtr ConnFactory::makeChannelInput(base::OutputPortInterface& port, ConnPolicy const& policy) {
    const ElementPtr storage = port.buildStorage(policy);
    if (storage) storage->connectFrom(ElementPtr(port.getEndpoint()));
    return storage;
}

namespace {

/** The fault of a policy; null if it is valid. */
const char* fault(const ConnPolicy& policy) {
    if (policy.type == ConnPolicy::UNBUFFERED)
        return "UNBUFFERED is only for output streams, expected a type with storage";
    if (policy.type < ConnPolicy::DATA || policy.type > ConnPolicy::CIRCULAR_BUFFER)
        return "unknown type, expected DATA, BUFFER or CIRCULAR_BUFFER";
    if (policy.lock_policy < ConnPolicy::UNSYNC || policy.lock_policy > ConnPolicy::LOCK_FREE)
        return "unknown lock policy, expected UNSYNC, LOCKED or LOCK_FREE";
    if (policy.buffer_policy < PerConnection || policy.buffer_policy > Shared)
        return "unknown buffer policy, expected PerConnection, PerInputPort, PerOutputPort or Shared";
    if (policy.type != ConnPolicy::DATA && policy.size < 0) return "negative buffer size";
    if (policy.max_threads < 0 || policy.max_threads > 10000) return "max_threads is not between 0 and 10000";
    return nullptr;
}

void complete(ConnPolicy& policy) {
    if (policy.buffer_policy == UnspecifiedBufferPolicy) policy.buffer_policy = PerConnection;
    if (policy.buffer_policy == PerInputPort) policy.pull = ConnPolicy::PUSH;
    if (policy.buffer_policy == PerOutputPort) policy.pull = ConnPolicy::PULL;
    if (policy.max_threads == 0) {
        policy.max_threads = 2;
        if (policy.buffer_policy == PerInputPort || policy.buffer_policy == Shared) policy.max_threads += 10;
        if (policy.buffer_policy == PerOutputPort || policy.buffer_policy == Shared) policy.max_threads += 10;
    }
}

}  // namespace

std::unique_ptr<SampleStore> ConnFactory::makeStore(const types::TypeOps& ops, ConnPolicy& policy, const void* first) {
    complete(policy);
    if (const char* wrong = fault(policy)) {
        log(Error) << "invalid connection policy: " << wrong << "; found type " << policy.type << ", lock_policy "
                   << policy.lock_policy << ", buffer_policy " << policy.buffer_policy << ", size " << policy.size
                   << ", max_threads " << policy.max_threads << endlog();
        return nullptr;
    }
    StoreSpec spec;
    spec.kind = policy.type == ConnPolicy::DATA     ? StoreSpec::Data
                : policy.type == ConnPolicy::BUFFER ? StoreSpec::Buffer
                                                    : StoreSpec::CircularBuffer;
    spec.lock = static_cast<StoreSpec::Lock>(policy.lock_policy);
    spec.size = policy.type == ConnPolicy::DATA ? 1 : static_cast<std::size_t>(policy.size);
    spec.maxThreads = static_cast<std::size_t>(policy.max_threads);
    spec.oldData = policy.buffer_policy != PerOutputPort && policy.buffer_policy != Shared;
    const bool inParts = policy.max_threads >= kThreadsOfParts && policy.buffer_policy == PerConnection &&
                         spec.kind == StoreSpec::Buffer && spec.lock == StoreSpec::LockFree &&
                         !detail::fitsWordBuffer(ops, spec) && (first || ops.construct);
    std::unique_ptr<SampleStore> store =
        inParts ? detail::makePartedBuffer(ops, spec, first) : SampleStore::make(ops, spec, first);
    if (!store)
        log(Error) << "no storage for a connection: its type has no default value, or its size is too large"
                   << endlog();
    return store;
}

}  // namespace RTT::internal
