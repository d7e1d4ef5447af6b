// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Connects two ports, or ports and a shared connection.
#include <rtt/internal/ConnFactory.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/flow/sample_type_name.hpp>
#include <rtt/internal/flow/storage_core.hpp>
#include <rtt/types/TypeOps.hpp>

#include <cstring>

namespace RTT::internal {

using base::InputPortInterface;
using base::OutputPortInterface;
using base::PortInterface;
typedef ConnectionManager::Obstacle Obstacle;

namespace {

bool sameType(const types::TypeOps* a, const types::TypeOps* b) {
    return a && b && std::strcmp(a->id->name(), b->id->name()) == 0;
}

bool sameStorage(const ConnPolicy& a, const ConnPolicy& b) {
    return a.type == b.type && a.lock_policy == b.lock_policy && (a.type == ConnPolicy::DATA || a.size == b.size);
}

bool refuseMix(const PortInterface& output, const PortInterface& input, const ConnPolicy& policy) {
    log(Error) << "cannot connect output port " << output.getFullName() << " with input port " << input.getFullName()
               << " by a " << static_cast<BufferPolicy>(policy.buffer_policy)
               << " connection: one of them already has connections with another buffer policy" << endlog();
    return false;
}

bool refuseOther(const PortInterface& owner, const ConnPolicy& wanted, const ConnPolicy& existing) {
    log(Error) << "incompatible connection policies for the shared buffer of port " << owner.getFullName()
               << ": the new connection requests " << wanted << ", but the port already has " << existing << endlog();
    return false;
}

/** Fills a storage before the connection exists, without a signal to readers that the storage may already have. */
class Filling final : public base::ChannelElementBase {
public:
    explicit Filling(StorageCore& core) : core_(core) {}
    WriteStatus writeErased(const void* sample) override { return core_.store().write(sample); }
    WriteStatus sampleErased(const void* sample, bool reset) override {
        core_.store().setSample(sample, reset);
        return WriteSuccess;
    }
    StorageCore* storageCore() override { return &core_; }

private:
    StorageCore& core_;
};

bool fill(base::ChannelElementBase& storage, OutputPortInterface& output, bool init) {
    StorageCore* const core = storage.storageCore();
    if (!core) return output.initialise(storage, init);
    Filling filling(*core);
    return output.initialise(filling, init);
}

/** False, with an error logged, if the plugins of the ports were built with different definitions of their type. */
bool sameSchema(const PortInterface& a, const PortInterface& b) {
    const std::string difference = sampleDifference(a, b);
    if (difference.empty()) return true;
    log(Error) << "cannot connect " << a.getFullName() << " with " << b.getFullName()
               << ": their plugins were built with different definitions of " << sampleTypeName(a) << ": " << difference
               << "; build both with the same header" << endlog();
    return false;
}

/** False, with an error logged, if the two can never be connected directly. */
bool checkEnds(OutputPortInterface& output, InputPortInterface& input) {
    if (!output.isLocal())
        log(Error) << "output port " << output.getFullName()
                   << " is a proxy for one in another process: connections start at a local output port" << endlog();
    else if (!sameType(output.sampleOps(), input.sampleOps()))
        log(Error) << "output port " << output.getFullName() << " of type " << sampleTypeName(output)
                   << " is not compatible with input port " << input.getFullName() << " of type "
                   << sampleTypeName(input) << endlog();
    else
        return sameSchema(output, input);
    return false;
}

bool outOfBand(OutputPortInterface& output, InputPortInterface& input, const ConnPolicy& policy) {
    // The first stream fills in the name and the size of samples; the second one joins it. The sender comes first,
    // because a receiver may wait for the sample that sizes it.
    const ConnPolicy both = policy;
    if (!ConnFactory::createStream(output, both, &input)) return false;
    if (ConnFactory::createStream(input, both, &output)) return true;
    (void)output.getManager()->disconnect(&input);
    return false;
}

/** Names the ports to which the previous error belongs. */
bool notConnected(const OutputPortInterface& output, const InputPortInterface& input) {
    log(Error) << "therefore output port " << output.getFullName() << " is not connected to input port "
               << input.getFullName() << endlog();
    return false;
}

bool connected(const OutputPortInterface& output, const InputPortInterface& input, const char* how) {
    log(how ? Info : Debug) << "output port " << output.getFullName() << " is " << (how ? how : "now")
                            << " connected to " << input.getFullName() << endlog();
    return true;
}

}  // namespace

bool ConnFactory::createConnection(OutputPortInterface& output, InputPortInterface& input, ConnPolicy const& wanted) {
    if (output.isLocal() && output.connectedTo(&input)) return connected(output, input, "already");
    if (output.isLocal() && !input.isLocal()) return input.connectFrom(output, wanted);
    if (wanted.buffer_policy == Shared) return createSharedConnection(&output, &input, nullptr, wanted);
    if (!checkEnds(output, input)) return false;
    if (wanted.transport != 0) return outOfBand(output, input, wanted);

    for (;;) {
        ElementPtr storage = input.buildStorage(wanted);  // also checks and completes the policy
        if (!storage) return notConnected(output, input);
        ConnPolicy policy = storage->getConnPolicy() ? *storage->getConnPolicy() : wanted;
        PortInterface& owner = policy.buffer_policy == PerOutputPort ? static_cast<PortInterface&>(output) : input;
        ConnPolicy existing;
        const ElementPtr shared = owner.getManager()->sharedStorage(policy, &existing);
        if (shared && !sameStorage(policy, existing)) return refuseOther(owner, policy, existing);
        if (shared) storage = shared;

        // Without a signal: the storage is filled before the reader can see it. A value written between this and join()
        // was written before the connection existed.
        if (!fill(*storage, output, policy.init)) return false;
        if (!input.channelReady(storage, policy)) {
            log(Error) << "input port " << input.getFullName()
                       << " could not read from the connection with output port " << output.getFullName() << endlog();
            return false;
        }
        const Obstacle obstacle =
            ConnectionManager::join(*output.getManager(), *input.getManager(), storage, policy, shared.get());
        Reclaimer::collect();
        if (obstacle == ConnectionManager::Retry) continue;
        if (obstacle == ConnectionManager::AlreadyConnected) return connected(output, input, "already");
        if (obstacle != ConnectionManager::None) return refuseMix(output, input, policy);
        // The other readers of a shared buffer were signalled when this value was written.
        if (policy.init && output.hasLastWrittenValue()) (void)input.getEndpoint()->signal();
        if (policy.type != ConnPolicy::DATA && policy.size == 0)
            log(Warning) << "the connection of output port " << output.getFullName() << " with input port "
                         << input.getFullName() << " is a buffer of size 0: every write will fail" << endlog();
        return connected(output, input, nullptr);
    }
}

namespace {

/** The shared connection for the ports to join; null, with an error logged, if there can be none. */
SharedConnectionBase::shared_ptr findOrMakeShared(PortInterface& port, SharedConnectionBase::shared_ptr given,
                                                  ConnPolicy const& policy) {
    if (!given && !policy.name_id.empty()) given = SharedConnectionRepository::Instance().get(policy.name_id);
    if (!given) {
        const auto storage = port.buildStorage(policy);
        if (!storage) return nullptr;
        if (policy.name_id.empty()) policy.name_id = SharedConnectionRepository::Instance().uniqueName();
        given = SharedConnectionRepository::Instance().add(
            new SharedConnectionBase(policy.name_id, storage, *storage->getConnPolicy(), port));
    }
    policy.name_id = given->getName();
    const std::string difference = sameType(&given->ops(), port.sampleOps()) ? given->difference(port) : "";
    if (!difference.empty()) {
        log(Error) << "port " << port.getFullName() << " cannot join shared connection '" << given->getName()
                   << "': its plugin was built with another definition of " << sampleTypeName(port) << ": "
                   << difference << "; build all with the same header" << endlog();
        return nullptr;
    }
    if (!sameType(&given->ops(), port.sampleOps()) || !sameStorage(given->getPolicy(), policy)) {
        log(Error) << "incompatible connection policies for shared connection '" << given->getName() << "': port "
                   << port.getFullName() << " of type " << sampleTypeName(port) << " requests " << policy
                   << ", but the connection of type " << sampleTypeName(given->ops()) << " is " << given->getPolicy()
                   << endlog();
        return nullptr;
    }
    return given;
}

bool joinShared(PortInterface& port, const SharedConnectionBase::shared_ptr& connection) {
    const Obstacle obstacle = port.getManager()->join(connection);
    if (obstacle == ConnectionManager::None || obstacle == ConnectionManager::AlreadyConnected) return true;
    log(Error) << "port " << port.getFullName() << " cannot join shared connection '" << connection->getName()
               << "': it already has another connection" << endlog();
    return false;
}

}  // namespace

bool ConnFactory::createSharedConnection(OutputPortInterface* output, InputPortInterface* input,
                                         SharedConnectionBase::shared_ptr connection, ConnPolicy const& wanted) {
    if (output && input && !checkEnds(*output, *input)) return false;
    ConnPolicy policy = wanted;
    policy.buffer_policy = Shared;
    SharedConnectionBase::shared_ptr has[2];  // a port in a shared connection already extends it
    for (PortInterface* port : {static_cast<PortInterface*>(output), static_cast<PortInterface*>(input)})
        if (port) has[port == output ? 0 : 1] = port->getSharedConnection();
    for (const SharedConnectionBase::shared_ptr& one : has) {
        if (!one) continue;
        if ((connection && connection != one) || (!policy.name_id.empty() && policy.name_id != one->getName())) {
            log(Error) << "a port of shared connection '" << one->getName() << "' cannot also join '"
                       << (connection ? connection->getName() : policy.name_id) << "'" << endlog();
            return false;
        }
        connection = one;
    }
    PortInterface& any = output ? static_cast<PortInterface&>(*output) : *input;
    if (connection && policy.name_id.empty()) policy.name_id = connection->getName();
    connection = findOrMakeShared(any, connection, policy);
    // Assigned only if it changes: several threads may be connecting with the same policy.
    if (wanted.name_id != policy.name_id) wanted.name_id = policy.name_id;
    if (!connection) return false;

    if (output && !has[0] && !fill(*connection->storage(), *output, policy.init)) return false;
    const bool done = (!input || joinShared(*input, connection)) && (!output || joinShared(*output, connection));
    if (!done && input && !has[1]) (void)input->getManager()->removeChannel(connection->storage().get());
    Reclaimer::collect();
    if (done && output && !has[0] && policy.init && output->hasLastWrittenValue())
        (void)connection->storage()->signal();
    return done;
}

}  // namespace RTT::internal
