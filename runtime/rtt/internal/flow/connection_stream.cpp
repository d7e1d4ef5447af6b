// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Joins a transport's topic, queue or other stream.
#include <rtt/internal/ConnFactory.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/internal/flow/sample_type_name.hpp>
#include <rtt/internal/flow/storage_core.hpp>
#include <rtt/types/Schema.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeMarshaller.hpp>
#include <rtt/types/TypeThunkTable.hpp>

#include <algorithm>
#include <memory>

namespace RTT::internal {

namespace {

std::string describe(const base::PortInterface& port) {
    return port.asInput() ? "input port " + port.getFullName() : "output port " + port.getFullName();
}

/** Receives the sizing sample for a new channel, as a value of the port's type. */
class SizingSample final : public base::ChannelElementBase {
public:
    explicit SizingSample(const types::TypeInfo& type) : value_(type.buildValue()) {}
    WriteStatus sampleErased(const void* sample, bool) override {
        if (value_) value_->assignValue(sample);
        return WriteSuccess;
    }
    const base::DataSourceBase::shared_ptr& value() const { return value_; }

private:
    base::DataSourceBase::shared_ptr value_;
};

/** The size in bytes of a sample like the last one written to the port, or like that of setDataSample() before. */
int marshalledSize(base::OutputPortInterface& port, const types::TypeMarshaller& marshaller) {
    const boost::intrusive_ptr<SizingSample> sizing(new SizingSample(*port.getTypeInfo()));
    (void)port.initialise(*sizing, false);
    if (!sizing->value()) return 0;
    void* cookie = marshaller.createCookie();
    const int size = static_cast<int>(marshaller.getSampleSize(sizing->value(), cookie));
    marshaller.deleteCookie(cookie);
    return size;
}

/** False, with an error logged, if the transport's typekit has another definition of the port's type. */
bool isSeenAlike(const base::PortInterface& port, const types::TypeInfo& type) {
    const types::TypeThunks* const thunks = type.getThunks();
    if (!thunks || !thunks->schema || !port.sampleSchema()) return true;
    const std::string difference =
        types::schemaDifference(*port.sampleSchema(), thunks->schema(), "in the port's plugin", "in the typekit");
    if (difference.empty()) return true;
    log(Error) << "could not create transport stream for " << describe(port)
               << ": its plugin was built with another definition of " << type.getTypeName()
               << " than the typekit: " << difference << "; build both with the same header" << endlog();
    return false;
}

/** Transports of ROS come with packages of types, whose names follow from those of the types. */
std::string hint(const ConnPolicy& policy, const std::string& typeName) {
    constexpr int kRos = 3;
    if (policy.transport != kRos) return {};
    std::string package = "std_msgs";  // has those of plain types, too
    const std::size_t begin = typeName.find_first_not_of("/:");
    const std::size_t end = begin == std::string::npos ? begin : typeName.find_first_of("/:.", begin);
    if (end != std::string::npos) package = typeName.substr(begin, end - begin);
    return ": import rtt_roscomm and rtt_" + package;
}

/** The channel element of the transport; null, with errors logged, if there is none. */
base::ChannelElementBase::shared_ptr transportElement(base::PortInterface& port, ConnPolicy const& policy,
                                                      bool sender) {
    const types::TypeInfo* type = port.getTypeInfo();
    if (policy.transport == 0) {
        log(Error) << describe(port) << ": need a transport for creating streams, found policy.transport 0" << endlog();
        return nullptr;
    }
    types::TypeTransporter* transport =
        type && type->hasProtocol(policy.transport) ? type->getProtocol(policy.transport) : nullptr;
    if (!transport) {
        log(Error) << "could not create transport stream for " << describe(port) << " with transport id "
                   << policy.transport << endlog();
        log(Error) << "no such transport registered; check policy.transport, or load the transport for type "
                   << sampleTypeName(port) << hint(policy, sampleTypeName(port)) << endlog();
        return nullptr;
    }
    if (!isSeenAlike(port, *type)) return nullptr;
    const types::TypeMarshaller* marshaller = dynamic_cast<types::TypeMarshaller*>(transport);
    if (sender && marshaller)
        policy.data_size =
            std::max(policy.data_size, marshalledSize(static_cast<base::OutputPortInterface&>(port), *marshaller));
    base::ChannelElementBase::shared_ptr element = transport->createStream(&port, policy, sender);
    if (!element)
        log(Error) << "transport " << policy.transport << " failed to create a remote channel for " << describe(port)
                   << endlog();
    return element;
}

typedef base::ChannelElementBase::shared_ptr ElementPtr;

ElementPtr created(const base::PortInterface& port, ConnPolicy const& policy, const ElementPtr& element) {
    log(Info) << "created stream '" << policy.name_id << "' for " << describe(port) << endlog();
    return element;
}

/** `newId`: makes the identification, when the name of the stream is known. */
template <class NewId>
ElementPtr joined(base::OutputPortInterface& output, ConnPolicy const& policy, const ElementPtr& beyond, NewId newId) {
    const ElementPtr element = transportElement(output, policy, true);
    if (!element) return nullptr;
    if (beyond) (void)element->connectTo(beyond);
    if (output.addConnection(newId(), element, policy)) return created(output, policy, element);
    element->disconnect(nullptr, true);
    return nullptr;
}

template <class NewId>
ElementPtr joined(base::InputPortInterface& input, ConnPolicy const& policy, const ElementPtr& beyond, NewId newId) {
    const ElementPtr element = transportElement(input, policy, false);
    if (!element) return nullptr;
    if (beyond) (void)beyond->connectTo(element);
    const ElementPtr storage = ConnFactory::makeChannelOutput(input, policy);
    if (storage && element->connectTo(storage) && input.channelReady(storage, policy, newId())) {
        // A sample that came before the port knew the storage has signalled a port that could not read it.
        const StorageCore* const core = storage->storageCore();
        if (core && core->store().size() != 0) (void)input.getEndpoint()->signal();
        return created(input, policy, element);
    }
    log(Error) << describe(input) << " could not read from the stream '" << policy.name_id << "'" << endlog();
    element->disconnect(nullptr, true);
    return nullptr;
}

ConnID* newId(const ConnPolicy& policy, base::PortInterface* partner) {
    return partner ? new OutOfBandConnID(policy.name_id, *partner) : new StreamConnID(policy.name_id);
}

}  // namespace

bool ConnFactory::createStream(base::OutputPortInterface& output, ConnPolicy const& policy,
                               base::InputPortInterface* partner) {
    return joined(output, policy, nullptr, [&] { return newId(policy, partner); }) != nullptr;
}

bool ConnFactory::createStream(base::InputPortInterface& input, ConnPolicy const& policy,
                               base::OutputPortInterface* partner) {
    return joined(input, policy, nullptr, [&] { return newId(policy, partner); }) != nullptr;
}

ConnFactory::ElementPtr ConnFactory::createStream(base::OutputPortInterface& output, ConnPolicy const& policy,
                                                  std::unique_ptr<ConnID> id, ElementPtr const& beyond) {
    return joined(output, policy, beyond, [&] { return id.release(); });
}

ConnFactory::ElementPtr ConnFactory::createStream(base::InputPortInterface& input, ConnPolicy const& policy,
                                                  std::unique_ptr<ConnID> id, ElementPtr const& beyond) {
    return joined(input, policy, beyond, [&] { return id.release(); });
}

}  // namespace RTT::internal
