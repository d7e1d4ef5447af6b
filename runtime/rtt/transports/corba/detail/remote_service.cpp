// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/remote_service.hpp>

#include <rtt/Logger.hpp>
#include <rtt/transports/corba/RemotePorts.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/transports/corba/detail/lone_service.hpp>
#include <rtt/transports/corba/detail/remote_part.hpp>
#include <rtt/transports/corba/detail/remote_value.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <boost/make_shared.hpp>

#include <algorithm>
#include <set>
#include <string>

namespace RTT::corba::detail {

namespace {

typedef std::shared_ptr<RemotePeer> Peer;
typedef std::shared_ptr<RemoteReference> Reference;

/** Null, with an error logged, if no typekit knows it. */
const types::TypeInfo* typeOf(const char* name, const std::string& what) {
    const types::TypeInfo* const type = types::Types()->type(name);
    if (!type || !transporterOf(*type))
        log(Error) << what << " is left out: no typekit of this process knows its type " << name
                   << "; import the package of the type" << endlog();
    return type && transporterOf(*type) ? type : nullptr;
}

void addOperations(Service& service, const std::shared_ptr<const RemoteReference>& reference,
                   const CServiceDescription& described, const Peer& peer) {
    for (CORBA::ULong i = 0; i != described.operations.length(); ++i) {
        const COperation& one = described.operations[i];
        const auto* const known = dynamic_cast<const RemotePart*>(service.getPart(one.name.in()));
        if (!known || !known->is(one)) service.add(one.name.in(), new RemotePart(peer, reference, one));
    }
}

/** The bag for the property "a.b.c" is that of "a.b", which is described before. */
PropertyBag* bagFor(PropertyBag& root, const std::string& path, std::string& name) {
    const std::size_t dot = path.rfind('.');
    name = dot == std::string::npos ? path : path.substr(dot + 1);
    if (dot == std::string::npos) return &root;
    auto* const outer = dynamic_cast<Property<PropertyBag>*>(findProperty(root, path.substr(0, dot)));
    return outer ? &outer->value() : nullptr;
}

void addProperty(PropertyBag& root, const Reference& reference, const CConfigurationInterface::CProperty& one,
                 const Peer& peer) {
    const std::string path = one.name.in();
    std::string name;
    PropertyBag* const bag = bagFor(root, path, name);
    if (!bag || bag->find(name)) return;
    if (std::string(one.type_name) == "PropertyBag") {
        bag->ownProperty(new Property<PropertyBag>(name, one.description.in()));
        return;
    }
    const types::TypeInfo* const type = typeOf(one.type_name, "property '" + path + "' of '" + peer->name() + "'");
    if (!type) return;
    const base::DataSourceBase::shared_ptr value =
        newRemoteValue(*type, {peer, reference, RemoteAccess::Kind::Property, path}, true);
    if (!value) return;
    (void)value->evaluate();
    if (base::PropertyBase* const made = type->buildProperty(name, one.description.in(), value)) bag->ownProperty(made);
}

void addAttribute(Service& service, const Reference& reference, const CConfigurationInterface::CAttribute& one,
                  const Peer& peer) {
    const std::string name = one.name.in();
    if (service.getValue(name)) return;
    const types::TypeInfo* const type = typeOf(one.type_name, "attribute '" + name + "' of '" + peer->name() + "'");
    if (!type) return;
    const base::DataSourceBase::shared_ptr value =
        newRemoteValue(*type, {peer, reference, RemoteAccess::Kind::Attribute, name}, one.assignable);
    if (value)
        (void)service.setValue(one.assignable ? type->buildAttribute(name, value) : type->buildConstant(name, value));
}

void attach(base::PortInterface& port, CService_ptr reference) {
    if (auto* const input = dynamic_cast<RemoteInputPort*>(&port)) input->attach(reference);
    if (auto* const output = dynamic_cast<RemoteOutputPort*>(&port)) output->attach(reference);
}

void addPort(Service& service, CService_ptr reference, const CPortDescription& one, const Peer& peer,
             RemotePortList& ports) {
    const std::string name = one.name.in();
    if (base::PortInterface* const known = service.getPort(name)) return attach(*known, reference);
    const types::TypeInfo* const type = typeOf(one.type_name, "port '" + name + "' of '" + peer->name() + "'");
    if (!type) return;
    if (one.type == CInput)
        ports.emplace_back(new RemoteInputPort(type, reference, name));
    else
        ports.emplace_back(new RemoteOutputPort(type, reference, name));
    service.addLocalPort(*ports.back()).doc(one.description.in());
}

void addChild(Service& service, CService_ptr reference, const CServiceDescription& described, const Peer& peer,
              RemotePortList& ports, const std::string& prefix) {
    const std::string name = described.name.in();
    Service::shared_ptr child = service.getService(name);
    if (!child) {
        child = boost::make_shared<Service>(name);
        if (!service.addService(child)) return;
    }
    fill(*child, reference, described, peer, ports, prefix + name);
}

/** Servers of the original describe the first child only. */
void addUndescribed(Service& service, CService_ptr reference, const CServiceDescription& described, const Peer& peer,
                    RemotePortList& ports, const std::string& prefix) {
    std::set<std::string> known{"this"};
    for (CORBA::ULong i = 0; i != described.children_descriptions.length(); ++i)
        known.insert(described.children_descriptions[i].name.in());
    for (CORBA::ULong i = 0; i != described.ports.length(); ++i) known.insert(described.ports[i].name.in());
    CService::CProviderNames_var names = reference->getProviderNames();
    for (CORBA::ULong i = 0; i != names->length(); ++i) {
        if (known.count(names[i].in())) continue;
        const CService_var child = reference->getService(names[i]);
        if (CORBA::is_nil(child)) continue;
        const CServiceDescription_var its = limited<CService>(child)->getCServiceDescription();
        addChild(service, child, its.in(), peer, ports, prefix);
    }
}

}  // namespace

void fill(Service& service, CService_ptr reference, const CServiceDescription& described, const Peer& peer,
          RemotePortList& ports, const std::string& path) {
    const Reference own = peer->service(path);
    own->set(reference);
    service.doc(described.description.in());
    addOperations(service, own, described, peer);
    for (CORBA::ULong i = 0; i != described.properties.length(); ++i)
        addProperty(*service.properties(), own, described.properties[i], peer);
    for (CORBA::ULong i = 0; i != described.attributes.length(); ++i)
        addAttribute(service, own, described.attributes[i], peer);
    for (CORBA::ULong i = 0; i != described.ports.length(); ++i)
        addPort(service, reference, described.ports[i], peer, ports);
    const std::string prefix = path.empty() ? path : path + ".";
    const CORBA::ULong children = std::min(described.children.length(), described.children_descriptions.length());
    for (CORBA::ULong i = 0; i != children; ++i)
        addChild(service, described.children[i], described.children_descriptions[i], peer, ports, prefix);
    addUndescribed(service, own->getLimited(), described, peer, ports, prefix);
}

Service::shared_ptr newRemoteService(CService_ptr reference) {
    const CServiceDescription_var described = reference->getCServiceDescription();
    const std::string name = described->name.in();
    const Service::shared_ptr made = boost::make_shared<Service>(name);
    const std::shared_ptr<LoneService> peer = LoneService::of(reference, name);
    addOperations(*made, peer->reference(), described.in(), peer);
    return made;
}

}  // namespace RTT::corba::detail
