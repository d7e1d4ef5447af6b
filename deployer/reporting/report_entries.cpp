// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is reported: peers, ports and values by name, and the property ReportData that lists them.
#include "reporting_state.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <algorithm>

namespace OCL {

using reporting::Source;
using RTT::endlog;
using RTT::log;
using RTT::TaskContext;
using RTT::base::DataSourceBase;
using RTT::base::InputPortInterface;
using RTT::base::OutputPortInterface;

namespace {

/** The service that `path`, with dots, ends in, and the last part of it; null if there is none. */
RTT::Service::shared_ptr serviceOf(TaskContext& component, std::string& path) {
    RTT::Service::shared_ptr service = component.provides();
    for (std::size_t dot; service && (dot = path.find('.')) != path.npos; path.erase(0, dot + 1))
        service = service->getService(path.substr(0, dot));
    return service;
}

DataSourceBase::shared_ptr valueOf(TaskContext& component, std::string path) {
    const RTT::Service::shared_ptr service = serviceOf(component, path);
    if (!service) return nullptr;
    if (const RTT::base::PropertyBase* const property = service->getProperty(path)) return property->getDataSource();
    const RTT::base::AttributeBase* const attribute = service->getAttribute(path);
    return attribute ? attribute->getDataSource() : nullptr;
}

/** Null, and an error, if values of that type cannot be reported. */
DataSourceBase::shared_ptr placeFor(const RTT::types::TypeInfo* type, const std::string& name) {
    const bool known = type && type != RTT::types::Types()->unknownType();
    const DataSourceBase::shared_ptr place = known ? type->buildValue() : nullptr;
    if (place && place->getRawPointer()) return place;
    log(RTT::Error) << "could not report '" << name << "': unknown type; no loaded typekit has it" << endlog();
    return nullptr;
}

TaskContext* peerOf(TaskContext& self, const std::string& component) {
    TaskContext* const peer = self.getPeer(component);
    if (!peer) {
        const TaskContext::PeerList peers = self.getPeerList();
        std::string known;
        for (const std::string& name : peers) known += (known.empty() ? "" : ", ") + name;
        log(RTT::Error) << "'" << self.getName() << "' could not report component '" << component
                        << "': no such peer; its peers: " << (known.empty() ? "none" : known) << endlog();
    }
    return peer;
}

}  // namespace

bool ReportingComponent::Impl::isReported(const std::string& name) const {
    return std::any_of(sources.begin(), sources.end(), [&](const auto& source) { return source->name() == name; });
}

bool ReportingComponent::Impl::isConnected(const std::string& name) const {
    return std::any_of(sources.begin(), sources.end(), [&](const auto& source) {
        return source->name() == name && (!source->port() || source->port()->connected());
    });
}

bool ReportingComponent::Impl::remove(const std::string& name) {
    const auto found = std::find_if(sources.begin(), sources.end(), [&](const auto& s) { return s->name() == name; });
    if (found == sources.end()) return false;
    if (InputPortInterface* const port = (*found)->port()) self.ports()->removePort(port->getName());
    sources.erase(found);
    return true;
}

bool ReportingComponent::Impl::addComponent(const std::string& component) {
    TaskContext* const peer = peerOf(self, component);
    if (!peer) return false;
    // A port of a type that no typekit has is said to be left out: the others of such a component have their columns.
    for (RTT::base::PortInterface* port : peer->ports()->getPorts())
        if (dynamic_cast<OutputPortInterface*>(port)) (void)addPort(component, port->getName());
    return true;
}

bool ReportingComponent::Impl::addPort(const std::string& component, const std::string& path) {
    TaskContext* const peer = peerOf(self, component);
    if (!peer) return false;
    std::string last = path;
    const RTT::Service::shared_ptr service = serviceOf(*peer, last);
    RTT::base::PortInterface* const port = service ? service->getPort(last) : nullptr;
    if (!port) {
        log(RTT::Error) << "could not report port '" << path << "': no such port on component '" << component << "'"
                        << endlog();
        return false;
    }
    auto* const output = dynamic_cast<OutputPortInterface*>(port);
    if (!output) {
        log(RTT::Error) << "can not report input port '" << path << "' of component '" << component << "'" << endlog();
        return false;
    }
    const std::string name = component + "." + path;
    const DataSourceBase::shared_ptr sample = placeFor(port->getTypeInfo(), name);
    if (!sample) return false;
    if (isReported(name)) {
        log(RTT::Warning) << "already reporting '" << name << "': removing the old port first" << endlog();
        (void)remove(name);
    }
    std::unique_ptr<InputPortInterface> input(port->getTypeInfo()->inputPort(component + "_" + path));
    if (!input || !output->connectTo(input.get(), policy)) {
        log(RTT::Error) << "could not report '" << name << "': its port takes no connection" << endlog();
        return false;
    }
    input->doc("Reports " + name);
    self.ports()->addLocalEventPort(*input);
    input->signalInterface(false);  // until the component runs
    sources.push_back(std::make_shared<Source>(component, path, std::move(input), sample));
    return true;
}

bool ReportingComponent::Impl::addData(const std::string& component, const std::string& data) {
    TaskContext* const peer = peerOf(self, component);
    if (!peer) return false;
    const std::string name = component + "." + data;
    const DataSourceBase::shared_ptr value = valueOf(*peer, data);
    if (!value) {
        log(RTT::Error) << "could not report '" << data << "': no such property or attribute of component '"
                        << component << "'" << endlog();
        return true;  // files that name what is not there have always been accepted
    }
    const DataSourceBase::shared_ptr sample = placeFor(value->getTypeInfo(), name);
    if (!sample) return false;
    (void)remove(name);
    sources.push_back(std::make_shared<Source>(component, data, value, sample));
    return true;
}

void ReportingComponent::Impl::findValuesAnew() {
    for (const std::shared_ptr<Source>& source : reporting::Sources(sources)) {
        if (source->port()) continue;
        TaskContext* const peer = self.getPeer(source->component());
        const DataSourceBase::shared_ptr value = peer ? valueOf(*peer, source->path()) : nullptr;
        if (value == source->original()) continue;
        const auto at = std::find(sources.begin(), sources.end(), source);
        const DataSourceBase::shared_ptr sample = value ? placeFor(value->getTypeInfo(), source->name()) : nullptr;
        if (sample) {
            *at = std::make_shared<Source>(source->component(), source->path(), value, sample);
            continue;
        }
        log(RTT::Error) << "'" << self.getName() << "' no longer reports '" << source->name()
                        << "': no such peer, or it has no such property or attribute any more" << endlog();
        sources.erase(at);
    }
}

bool ReportingComponent::Impl::removeAllOf(const std::string& component) {
    bool any = false;
    const std::string prefix = component + ".";
    for (const std::shared_ptr<Source>& source : reporting::Sources(sources)) {
        if (source->name().compare(0, prefix.size(), prefix) != 0) continue;
        any |= remove(source->name());
        forgetEntry("Port", source->name());
        forgetEntry("Data", source->name());
    }
    forgetEntry("Component", component);
    return any;
}

// --- the property ReportData ---------------------------------------------------------------------------------------

bool ReportingComponent::Impl::addEntries() {
    if (reportData.empty()) {
        log(RTT::Error) << "'" << self.getName() << "': the property ReportData is empty: there is nothing to report"
                        << endlog();
        log(RTT::Error) << "fill it by Properties or LoadProperties of the deployment file or by "
                           "marshalling.loadProperties(), or use "
                           "the operations reportComponent, reportPort and reportData"
                        << endlog();
        return false;
    }
    bool good = true;
    for (const RTT::base::PropertyBase* entry : reportData) good &= addEntry(*entry);
    return good;
}

bool ReportingComponent::Impl::addEntry(const RTT::base::PropertyBase& entry) {
    const auto* const text = dynamic_cast<const RTT::Property<std::string>*>(&entry);
    if (!text) {
        log(RTT::Error) << "property \"" << entry.getName() << "\" of ReportData: found type " << entry.getType()
                        << ", expected string" << endlog();
        return false;
    }
    const std::string& kind = entry.getName();
    const std::string value = text->get();
    if (kind == "Component") return addComponent(value);
    if (kind != "Port" && kind != "Data") {
        log(RTT::Error) << "property of ReportData: found name \"" << kind
                        << "\", expected \"Component\", \"Port\" or \"Data\"" << endlog();
        return false;
    }
    const std::size_t dot = value.find('.');
    if (dot == 0 || dot == value.npos || dot + 1 == value.size()) {
        log(RTT::Error) << "property \"" << kind << "\" of ReportData: found '" << value
                        << "', expected the name of a component, a dot and the name of one of its "
                        << (kind == "Port" ? "ports" : "properties or attributes") << endlog();
        return false;
    }
    // By an operation that was called before configure(). A port that has gone since is looked for again.
    if (isConnected(value)) return true;
    if (kind == "Port") (void)remove(value);
    const std::string component = value.substr(0, dot), name = value.substr(dot + 1);
    return kind == "Port" ? addPort(component, name) : addData(component, name);
}

void ReportingComponent::Impl::rememberEntry(const std::string& kind, const std::string& value) {
    forgetEntry(kind, value);
    reportData.ownProperty(new RTT::Property<std::string>(kind, "", value));
}

void ReportingComponent::Impl::forgetEntry(const std::string& kind, const std::string& value) {
    for (RTT::base::PropertyBase* entry : RTT::PropertyBag::Properties(reportData.getProperties())) {
        const auto* const text = dynamic_cast<RTT::Property<std::string>*>(entry);
        if (text && text->getName() == kind && text->get() == value) reportData.removeProperty(entry);
    }
}

void ReportingComponent::Impl::forgetAll() {
    while (!sources.empty()) (void)remove(sources.back()->name());
    reportData.clear();
}

}  // namespace OCL
