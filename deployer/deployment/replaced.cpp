// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replaced.hpp"

#include "port_faults.hpp"
#include "session.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/ComponentDescription.hpp>

#include <algorithm>
#include <set>

namespace OCL::deploy {
namespace {

using RTT::internal::ComponentDescription;

RecordedPorts* present = nullptr;

/** Does nothing itself. */
class StandIn final : public RTT::TaskContext {
public:
    using RTT::TaskContext::TaskContext;
};

const ComponentDescription* descriptionOf(const std::string& type) {
    const auto create = RTT::ComponentLoader::Instance()->factoryOf(type);
    return create ? RTT::internal::ComponentDescriptions::find(type, reinterpret_cast<const void*>(create)) : nullptr;
}

bool isRecorder(const std::string& type) { return type == "OCL::McapReporting"; }

/** True if it has an input that the library tells of; with a name, if that port is one. */
bool hasInput(const std::string& type, const std::string& port = std::string()) {
    const ComponentDescription* const described = descriptionOf(type);
    return described && std::any_of(described->ports.begin(), described->ports.end(), [&](const auto& known) {
               return !known.output && (port.empty() || port == known.name);
           });
}

/** True if neither the file tells all of its connections nor users want it to be replaced. */
bool isUnclear(const ComponentPlan& component) {
    return (component.ports.empty() || component.autoConnect.value_or(false)) &&
           !present->isWanted(component.name.value);
}

bool isKnown(const std::string& type) { return RTT::ComponentLoader::Instance()->factoryOf(type) != nullptr; }

bool hasInput(const RTT::Service& service) {
    auto& inside = const_cast<RTT::Service&>(service);  // it only has functions that are not const
    for (RTT::base::PortInterface* const port : inside.getPorts())
        if (port->asInput()) return true;
    for (const std::string& name : service.getProviderNames()) {
        const RTT::Service::shared_ptr inner = inside.getService(name);
        if (inner && hasInput(*inner)) return true;
    }
    return false;
}

/** Why the component runs; empty if it is replaced. */
std::string whyReal(const ComponentPlan& component, const std::set<std::string>& masters) {
    const std::string& name = component.name.value;
    if (isRecorder(component.type.value)) return {};
    if (!present->hasComponent(name)) return "it was not recorded";
    const std::optional<bool> wanted = present->isWanted(name);
    if (wanted && !*wanted) return "--replace does not name it";
    if (!component.members.empty()) return "it is a chain";
    if (masters.count(name)) return "it executes others";
    if (wanted) return {};
    for (const PortPlan& port : component.ports) {
        const std::string& portName = port.port.value;
        if (!present->hasPort(name, portName))
            return "its port '" + portName + "' was not recorded" + diag::didYouMean(portName, present->portsOf(name));
        if (hasInput(component.type.value, portName)) return "its port '" + portName + "' is an input";
    }
    return isUnclear(component) && hasInput(component.type.value) ? "it has an input" : "";
}

/** Libraries tell which ports are outputs, and so does the recording. */
bool isOutput(const ComponentPlan& component, const std::string& port) {
    if (present->hasPort(component.name.value, port)) return true;
    const ComponentDescription* const described = descriptionOf(component.type.value);
    return described && std::any_of(described->ports.begin(), described->ports.end(),
                                    [&](const auto& known) { return known.output && port == known.name; });
}

bool hasOutput(const Plan& plan, const std::string& connection) {
    for (const ComponentPlan& component : plan.components)
        for (const PortPlan& port : component.ports)
            if (port.connection.value == connection && isOutput(component, port.port.value)) return true;
    return false;
}

/** Reports a connected port that the recording lacks, unless it is an input. */
void reportUnrecorded(const Plan& plan, const ComponentPlan& component, const PortPlan& port, diag::Sink& sink) {
    const std::string &name = component.name.value, &portName = port.port.value;
    if (hasInput(component.type.value, portName)) return;
    std::vector<std::string> known = present->portsOf(name);
    if (const ComponentDescription* const described = descriptionOf(component.type.value)) {
        for (const auto& one : described->ports) known.emplace_back(one.name);
        const bool isComplete = !described->dynamic && component.services.empty() && component.scripts.empty();
        if (isComplete && !isOutput(component, portName)) return (void)reportUnknownPort(name, port.port, known, sink);
    }
    const std::string meant = diag::didYouMean(portName, known);
    const std::string text = "the recording has no port '" + name + "." + portName +
                             "', so nothing comes from it in connection '" + port.connection.value + "'" + meant;
    // What others send there is probably for it.
    if (meant.empty() && !isOutput(component, portName) && hasOutput(plan, port.connection.value))
        RTT::log(RTT::Info) << text << RTT::endlog();
    else
        sink.warning(port.port.where, "RPL014", text);
}

/** Reports a component that runs although --replace names it. */
void reportWanted(const ComponentPlan& component, const std::string& why, diag::Sink& sink) {
    sink.warning(component.name.where, "RPL015",
                 "component '" + component.name.value + "' runs, --replace cannot replace it: " + why);
}

void keepOnlyPorts(ComponentPlan& component) {
    ComponentPlan kept;
    kept.name = component.name;
    kept.type = component.type;
    kept.autoConf = component.autoConf;
    kept.autoStart = component.autoStart;
    kept.autoConnect = component.autoConnect;
    kept.ports = component.ports;
    kept.peers = component.peers;
    kept.isReplaced = true;
    // Users want it to be replaced in spite of its inputs.
    const auto isMissing = [&](const PortPlan& port) {
        return !present->hasPort(component.name.value, port.port.value);
    };
    kept.ports.erase(std::remove_if(kept.ports.begin(), kept.ports.end(), isMissing), kept.ports.end());
    component = std::move(kept);
}

/** Reports a port that is missing. */
void report(const ComponentPlan& component, const std::string& port, const std::string& problem, diag::Sink& sink) {
    const std::string text =
        "port '" + component.name.value + "." + port + "' of the recording cannot be replayed: " + problem;
    for (const PortPlan& connected : component.ports)
        if (connected.port.value == port) return (void)sink.error(connected.port.where, "RPL006", text);
    RTT::log(RTT::Warning) << "warning: ["
                           << "RPL006"
                           << "] " << text << RTT::endlog();
}

}  // namespace

void setRecordedPorts(RecordedPorts* ports) { present = ports; }
RecordedPorts* recordedPorts() { return present; }
bool isStandIn(const RTT::TaskContext& component) { return dynamic_cast<const StandIn*>(&component) != nullptr; }

ComponentPlan planOf(const std::string& name, const std::string& type) {
    ComponentPlan plan;
    plan.name.value = name;
    plan.type.value = type;
    if (!present) return plan;
    const std::optional<bool> wanted = present->isWanted(name);
    const bool mayBe = present->hasComponent(name) && wanted.value_or(true);
    plan.isReplaced = isRecorder(type) || (mayBe && (wanted || !isKnown(type)));
    plan.isReplacedWithoutInput = !plan.isReplaced && mayBe;
    return plan;
}

bool replaysInstead(const char* operation) {
    if (!present) return false;
    RTT::log(RTT::Info) << operation << "() does not wait: the replay begins when the scripts have ended"
                        << RTT::endlog();
    return true;
}

void replaceRecorded(const Session& session, Plan& plan, diag::Sink& sink) {
    if (!present) return;
    std::set<std::string> masters = session.masters, replaced;
    for (const ComponentPlan& component : plan.components)
        if (component.activity && !component.activity->master.empty()) masters.insert(component.activity->master.value);
    for (ComponentPlan& component : plan.components) {
        const std::string& name = component.name.value;
        if (component.type.empty() || session.component(name)) continue;  // it exists: these are more options
        const std::string why = whyReal(component, masters);
        if (present->hasComponent(name) && !why.empty())
            RTT::log(RTT::Info) << "component '" << name << "' runs, it is not replayed: " << why << RTT::endlog();
        if (!why.empty() && present->isWanted(name).value_or(false)) reportWanted(component, why, sink);
        if (!why.empty()) continue;
        if (isUnclear(component) && isKnown(component.type.value) && !isRecorder(component.type.value)) {
            component.isReplacedWithoutInput = true;
            continue;
        }
        if (!isRecorder(component.type.value))
            for (const PortPlan& port : component.ports)
                if (!present->hasPort(name, port.port.value)) reportUnrecorded(plan, component, port, sink);
        keepOnlyPorts(component);
        replaced.insert(name);
    }
    for (ComponentPlan& component : plan.components)
        component.members.erase(std::remove_if(component.members.begin(), component.members.end(),
                                               [&](const Text& member) { return replaced.count(member.value) != 0; }),
                                component.members.end());
}

RTT::TaskContext* createStandIn(Session& session, ComponentPlan& component, int group, diag::Sink& sink,
                                std::string& error) {
    const std::string& name = component.name.value;
    if (session.component(name)) {
        error = "a component of that name is already there";
        return nullptr;
    }
    if (component.isReplacedWithoutInput) {
        RTT::TaskContext* const itself = createItself(session, name, component.type.value, group, error);
        if (!itself) return nullptr;
        if (hasInput(*itself->provides())) {
            RTT::log(RTT::Info) << "component '" << name
                                << "' runs, it is not replayed: it has an input; --replace=" << name << " replaces it"
                                << RTT::endlog();
            return itself;
        }
        (void)unloadOne(session, *itself);
        keepOnlyPorts(component);
    }
    std::map<std::string, std::string> problems;
    const auto made = std::make_shared<StandIn>(name);
    if (!isRecorder(component.type.value)) present->addPorts(*made, problems);
    session.deployer->addPeer(made.get(), name);
    ComponentRecord& record = session.records.add(name, made.get());
    record.loadedHere = true;
    record.standIn = made;
    record.plan.type = component.type;
    record.group = record.optionsGroup = group;
    RTT::log(RTT::Info) << "component '" << name << "' is not created: "
                        << (isRecorder(component.type.value) ? "a replay records by --record"
                                                             : "the recording has its ports")
                        << RTT::endlog();
    for (const auto& [port, problem] : problems) report(component, port, problem, sink);
    return made.get();
}

}  // namespace OCL::deploy
