// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A transport as users write one: a conversion of a struct of theirs, the transporter made of it, and the plugin.
#include "downstream_types.hpp"

#include "sampleC.h"

#include <rtt/transports/corba/CorbaConversion.hpp>
#include <rtt/transports/corba/CorbaLib.hpp>
#include <rtt/transports/corba/CorbaTemplateProtocol.hpp>
#include <rtt/transports/corba/DataFlowI.h>
#include <rtt/transports/corba/DataSourceProxy.hpp>
#include <rtt/transports/corba/RemoteChannelElement.hpp>
#include <rtt/types/TransportPlugin.hpp>
#include <rtt/types/TypekitPlugin.hpp>

#include <string>
#include <vector>

namespace RTT {
namespace corba {

template <>
struct AnyConversion<downstream::Spot> {
    typedef orogen::sample::Corba::Point CorbaType;
    typedef downstream::Spot BaseType;

    static bool toCORBA(CorbaType& to, const BaseType& from) {
        to.x = from.east;
        to.y = from.north;
        return true;
    }
    static bool update(const CORBA::Any& any, BaseType& value) {
        CorbaType* found;
        if (!(any >>= found)) return false;
        value.east = found->x;
        value.north = found->y;
        return true;
    }
    static CORBA::Any_ptr createAny(const BaseType& value) {
        CORBA::Any_ptr made = new CORBA::Any();
        updateAny(value, *made);
        return made;
    }
    static bool updateAny(const BaseType& value, CORBA::Any& any) {
        CorbaType sent;
        toCORBA(sent, value);
        any <<= sent;
        return true;
    }
};

/** By the helper, with a sequence of its own. */
template <>
struct AnyConversion<downstream::Corner>
    : public AnyConversionHelper<downstream::Corner, orogen::sample::Corba::Point> {
    typedef orogen::sample::Corba::vector__sample_Point_ sequence;

    static bool toStdType(downstream::Corner& to, const CorbaType& from) {
        to.x = from.x;
        to.y = from.y;
        return true;
    }
    static bool toCorbaType(CorbaType& to, const downstream::Corner& from) {
        to.x = from.x;
        to.y = from.y;
        return true;
    }
};

}  // namespace corba
}  // namespace RTT

namespace downstream {

/** All by hand. */
class CornerTransporter : public RTT::corba::CorbaTypeTransporter {
public:
    typedef RTT::corba::AnyConversion<Corner> Conversion;

    CORBA::Any_ptr createAny(RTT::base::DataSourceBase::shared_ptr source) const {
        RTT::internal::DataSource<Corner>* typed = RTT::internal::DataSource<Corner>::narrow(source.get());
        return typed ? Conversion::createAny(typed->rvalue()) : 0;
    }
    bool updateAny(RTT::base::DataSourceBase::shared_ptr source, CORBA::Any& any) const {
        RTT::internal::DataSource<Corner>* typed = RTT::internal::DataSource<Corner>::narrow(source.get());
        return typed && Conversion::updateAny(typed->rvalue(), any);
    }
    RTT::base::DataSourceBase::shared_ptr createDataSource(const CORBA::Any* any) const {
        RTT::internal::ValueDataSource<Corner>::shared_ptr made = new RTT::internal::ValueDataSource<Corner>();
        if (!Conversion::update(*any, made->set())) return 0;
        return made;
    }
    bool updateFromAny(const CORBA::Any* any, RTT::base::DataSourceBase::shared_ptr target) const {
        RTT::internal::AssignableDataSource<Corner>* typed =
            RTT::internal::AssignableDataSource<Corner>::narrow(target.get());
        return typed && Conversion::update(*any, typed->set());
    }
    RTT::corba::CRemoteChannelElement_i* createChannelElement_i(RTT::DataFlowInterface* sender,
                                                                PortableServer::POA_ptr poa,
                                                                const RTT::ConnPolicy& policy) const {
        return new RTT::corba::RemoteChannelElement<Corner>(*this, sender, poa, policy);
    }
    RTT::base::ChannelElementBase::shared_ptr createStream(RTT::base::PortInterface*, const RTT::ConnPolicy&,
                                                           bool) const {
        return RTT::base::ChannelElementBase::shared_ptr();
    }
    RTT::base::DataSourceBase::shared_ptr createPropertyDataSource(RTT::corba::CService_ptr service,
                                                                   const std::string& name) {
        return new RTT::corba::ValueDataSourceProxy<Corner>(service, name, true);
    }
    RTT::base::DataSourceBase::shared_ptr createAttributeDataSource(RTT::corba::CService_ptr service,
                                                                    const std::string& name, bool assignable) {
        if (assignable) return new RTT::corba::ValueDataSourceProxy<Corner>(service, name, false);
        return new RTT::corba::DataSourceProxy<Corner>(service, name, false);
    }
};

class CorbaPlugin : public RTT::types::TransportPlugin {
public:
    bool registerTransport(std::string type_name, RTT::types::TypeInfo* ti) {
        if (type_name == "/downstream/Spot")
            return ti->addProtocol(ORO_CORBA_PROTOCOL_ID, new RTT::corba::CorbaTemplateProtocol<Spot>());
        if (type_name == "/downstream/Corner") return ti->addProtocol(ORO_CORBA_PROTOCOL_ID, new CornerTransporter());
        if (type_name == "/downstream/Corners")
            return ti->addProtocol(ORO_CORBA_PROTOCOL_ID, new RTT::corba::CorbaTemplateProtocol<std::vector<Corner>>());
        return false;
    }
    std::string getTransportName() const { return "CORBA"; }
    std::string getTypekitName() const { return "/orogen/downstream"; }
    std::string getName() const { return "/orogen/downstream/CORBA"; }
};

}  // namespace downstream

ORO_TYPEKIT_PLUGIN(downstream::CorbaPlugin)
