// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Selects what is reported: peers, ports and values by name, and the property ReportData, which lists them.
#include "report_name.hpp"
#include "reporting_state.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/dotted_name.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <algorithm>

namespace OCL {

using oroforge::diag::didYouMean;
using reporting::Source;
using RTT::endlog;
using RTT::log;
using RTT::TaskContext;
using RTT::base::DataSourceBase;
using RTT::base::InputPortInterface;
using RTT::base::OutputPortInterface;

namespace {

DataSourceBase::shared_ptr valueIn(RTT::Service& service, const std::string& name) {
    if (const RTT::base::PropertyBase* const property = service.getProperty(name)) return property->getDataSource();
    const RTT::base::AttributeBase* const attribute = service.getAttribute(name);
    return attribute ? attribute->getDataSource() : nullptr;
}

DataSourceBase::shared_ptr valueOf(TaskContext& component, const std::string& path) {
    return RTT::internal::findMember(*component.provides(), path, valueIn);
}

/** A new value of that type. Logs an error and returns null if values of the type cannot be reported. */
DataSourceBase::shared_ptr placeFor(const RTT::types::TypeInfo* type, const std::string& name) {
    const bool known = type && type != RTT::types::Types()->unknownType();
    const DataSourceBase::shared_ptr place = known ? type->buildValue() : nullptr;
    if (place && place->getRawPointer()) return place;
    log(RTT::Error) << "could not report '" << name << "': unknown type; no loaded typekit has it" << endlog();
    return nullptr;
}

std::shared_ptr<Source> sourceOf(TaskContext& peer, const std::string& component, const std::string& path,
                                 const DataSourceBase::shared_ptr& value, const DataSourceBase::shared_ptr& sample) {
    auto source = std::make_shared<Source>(component, path, value, peer.engine()->gate(), sample);
    if (const RTT::base::PropertyBase* const property = peer.provides()->getProperty(path))
        source->describe(property->getDescription());
    return source;
}

TaskContext* peerOf(TaskContext& self, const std::string& component) {
    TaskContext* const peer = self.getPeer(component);
    if (!peer) {
        const TaskContext::PeerList peers = self.getPeerList();
        std::string known;
        for (const std::string& name : peers) known += (known.empty() ? "" : ", ") + name;
        log(RTT::Error) << "'" << self.getName() << "' could not report component '" << component
                        << "': no such peer; its peers: " << (known.empty() ? "none" : known)
                        << didYouMean(component, peers) << endlog();
    } else if (reporting::hasControl(component)) {
        log(RTT::Error) << "'" << self.getName() << "' could not report component '" << component
                        << "': its name has a control character, such as a line end" << endlog();
        return nullptr;
    }
    return peer;
}

/** The port of the component, output or input; null if there is none. */
RTT::base::PortInterface* portOf(TaskContext& component, const std::string& path) {
    return RTT::internal::findPort(*component.provides(), path);
}

// The names of the component's own output ports, for messages.
std::vector<std::string> outputsOf(TaskContext& component) {
    std::vector<std::string> names;
    for (RTT::base::PortInterface* port : component.ports()->getPorts())
        if (port->asOutput()) names.push_back(port->getName());
    return names;
}
std::vector<std::string> valuesOf(TaskContext& component) {
    std::vector<std::string> names = component.attributes()->getAttributeNames();
    const std::vector<std::string> properties = component.properties()->list();
    names.insert(names.end(), properties.begin(), properties.end());
    return names;
}

/** The output port. Logs an error and returns null if there is none that can be reported. */
OutputPortInterface* outputOf(TaskContext& peer, const std::string& component, const std::string& path) {
    RTT::base::PortInterface* const port = portOf(peer, path);
    auto* const output = port ? port->asOutput() : nullptr;
    if (output) return output;
    if (port)
        log(RTT::Error) << "cannot report input port '" << path << "' of component '" << component << "'" << endlog();
    else
        log(RTT::Error) << "could not report port '" << path << "': no such port on component '" << component << "'"
                        << didYouMean(path, outputsOf(peer)) << endlog();
    return nullptr;
}

bool isEntry(const RTT::base::PropertyBase* entry, const std::string& kind, const std::string& value) {
    const auto* const text = dynamic_cast<const RTT::Property<std::string>*>(entry);
    return text && text->getName() == kind && text->get() == value;
}

}  // namespace

reporting::Sources::iterator ReportingComponent::Impl::find(const std::string& name) {
    return std::find_if(sources.begin(), sources.end(), [&](const auto& source) { return source->name() == name; });
}

bool ReportingComponent::Impl::isReported(const std::string& name) { return find(name) != sources.end(); }

bool ReportingComponent::Impl::isReportedNow(const std::string& name) {
    const auto found = find(name);
    return found != sources.end() && isUpToDate(**found);
}

bool ReportingComponent::Impl::isUpToDate(const Source& source) const {
    TaskContext* const peer = self.getPeer(source.component());
    if (!peer) return false;
    if (!source.port()) return valueOf(*peer, source.path()) == source.original();
    RTT::base::PortInterface* const port = portOf(*peer, source.path());
    return port && port->connectedTo(source.port());
}

std::string ReportingComponent::Impl::freeName(const std::string& component, const std::string& port) {
    const auto old = find(component + "." + port);
    const RTT::base::PortInterface* const replaced = old == sources.end() ? nullptr : (*old)->port();
    // Port c of component a_b and port b_c of component a would have the same name.
    std::string name = component + "_" + port;
    for (const RTT::base::PortInterface* at; (at = self.ports()->getPort(name)) && at != replaced;) name += "_";
    return name;
}

void ReportingComponent::Impl::put(std::shared_ptr<Source> source) {
    const auto old = find(source->name());
    if (old == sources.end()) {
        sources.push_back(source);
    } else {
        if (InputPortInterface* const port = (*old)->port()) self.ports()->removePort(port->getName());
        *old = source;
    }
    if (!source->port()) return;
    self.ports()->addLocalEventPort(*source->port());
    source->port()->signalInterface(false);  // no signals until the component runs
}

bool ReportingComponent::Impl::remove(const std::string& name) {
    const auto found = find(name);
    if (found == sources.end()) return false;
    if (InputPortInterface* const port = (*found)->port()) self.ports()->removePort(port->getName());
    sources.erase(found);
    return true;
}

bool ReportingComponent::Impl::addComponent(const std::string& component, Known known) {
    TaskContext* const peer = peerOf(self, component);
    if (!peer) return false;
    // A port whose type is in no typekit is left out with a message; the other ports of the component have columns.
    for (RTT::base::PortInterface* port : peer->ports()->getPorts()) {
        if (!port->asOutput()) continue;
        const bool stays = known == Known::Stay && isReportedNow(component + "." + port->getName());
        if (!stays) (void)addPort(component, port->getName());
    }
    return true;
}

bool ReportingComponent::Impl::addPort(const std::string& component, const std::string& path) {
    TaskContext* const peer = peerOf(self, component);
    OutputPortInterface* const output = peer ? outputOf(*peer, component, path) : nullptr;
    if (!output) return false;
    const std::string name = component + "." + path;
    if (isReportedNow(name))
        log(RTT::Warning) << "already reporting '" << name << "': removing the old port first" << endlog();
    return connect(component, path, *output);
}

bool ReportingComponent::Impl::connect(const std::string& component, const std::string& path,
                                       OutputPortInterface& output) {
    const std::string name = component + "." + path;
    const DataSourceBase::shared_ptr sample = placeFor(output.getTypeInfo(), name);
    if (!sample) return false;
    std::unique_ptr<InputPortInterface> input(output.getTypeInfo()->inputPort(freeName(component, path)));
    if (!input || !output.connectTo(input.get(), policy)) {
        log(RTT::Error) << "could not report '" << name << "': its port takes no connection" << endlog();
        return false;
    }
    input->doc("Reports " + name + ".");
    const auto source = std::make_shared<Source>(component, path, std::move(input), sample);
    source->describe(output.getDescription());
    put(source);
    return true;
}

bool ReportingComponent::Impl::addData(const std::string& component, const std::string& data) {
    TaskContext* const peer = peerOf(self, component);
    if (!peer) return false;
    const std::string name = component + "." + data;
    const DataSourceBase::shared_ptr value = valueOf(*peer, data);
    if (!value) {
        log(RTT::Error) << "could not report '" << data << "': no such property or attribute of component '"
                        << component << "'" << didYouMean(data, valuesOf(*peer)) << endlog();
        return true;  // files have always been accepted if they name something unknown
    }
    const DataSourceBase::shared_ptr sample = placeFor(value->getTypeInfo(), name);
    if (!sample) return false;
    put(sourceOf(*peer, component, data, value, sample));
    return true;
}

bool ReportingComponent::Impl::renew(const Source& source) {
    TaskContext* const peer = self.getPeer(source.component());
    if (source.port()) {
        // A port that does not exist any more keeps its column, with the last value.
        RTT::base::PortInterface* const port = peer ? portOf(*peer, source.path()) : nullptr;
        if (auto* const output = port ? port->asOutput() : nullptr)
            (void)connect(source.component(), source.path(), *output);
        return true;
    }
    const DataSourceBase::shared_ptr value = peer ? valueOf(*peer, source.path()) : nullptr;
    const DataSourceBase::shared_ptr sample = value ? placeFor(value->getTypeInfo(), source.name()) : nullptr;
    if (sample) {
        put(sourceOf(*peer, source.component(), source.path(), value, sample));
        return true;
    }
    log(RTT::Error) << "'" << self.getName() << "' leaves out '" << source.name()
                    << "': no such peer, or it has no such property or attribute any more" << endlog();
    return false;
}

reporting::Sources ReportingComponent::Impl::present() {
    reporting::Sources result;
    for (const std::shared_ptr<Source>& source : reporting::Sources(sources))
        if (isUpToDate(*source) || renew(*source)) result.push_back(*find(source->name()));
    return result;
}

bool ReportingComponent::Impl::removeAllOf(const std::string& component) {
    bool any = false;
    const std::string prefix = component + ".";
    for (const std::shared_ptr<Source>& source : reporting::Sources(sources)) {
        if (source->name().compare(0, prefix.size(), prefix) != 0) continue;
        any |= remove(source->name());
        (void)forgetEntry("Port", source->name());
        (void)forgetEntry("Data", source->name());
    }
    return forgetEntry("Component", component) || any;
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
    if (kind == "Component") return addComponent(value, Known::Stay);
    if (kind != "Port" && kind != "Data") {
        log(RTT::Error) << "property of ReportData: found name \"" << kind
                        << "\", expected \"Component\", \"Port\" or \"Data\""
                        << didYouMean(kind, {"Component", "Port", "Data"}) << endlog();
        return false;
    }
    const std::size_t dot = value.find('.');
    if (dot == 0 || dot == value.npos || dot + 1 == value.size()) {
        log(RTT::Error) << "property \"" << kind << "\" of ReportData: found '" << value
                        << "', expected the name of a component, a dot and the name of one of its "
                        << (kind == "Port" ? "ports" : "properties or attributes") << endlog();
        return false;
    }
    // Reported already, by an operation before configure(). If it does not exist any more, it is looked up again.
    if (isReportedNow(value)) return true;
    const std::string component = value.substr(0, dot), name = value.substr(dot + 1);
    return kind == "Port" ? addPort(component, name) : addData(component, name);
}

void ReportingComponent::Impl::rememberEntry(const std::string& kind, const std::string& value) {
    for (const RTT::base::PropertyBase* entry : reportData)
        if (isEntry(entry, kind, value)) return;  // keeps the place of its column
    reportData.ownProperty(new RTT::Property<std::string>(kind, "", value));
}

bool ReportingComponent::Impl::forgetEntry(const std::string& kind, const std::string& value) {
    bool any = false;
    for (RTT::base::PropertyBase* entry : RTT::PropertyBag::Properties(reportData.getProperties()))
        if (isEntry(entry, kind, value)) any |= reportData.removeProperty(entry);
    return any;
}

void ReportingComponent::Impl::forgetAll() {
    while (!sources.empty()) (void)remove(sources.back()->name());
    reportData.clear();
}

}  // namespace OCL
