// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "read_value.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>
#include <cpf/cpf_reader.hpp>

#include <utility>

namespace OCL::deploy {
namespace {

/** Reads an element into the plan, and may move its contents. */
using Reader = void (*)(xml::Element&, ComponentPlan&, diag::Sink&);

template <Flag ComponentPlan::*member>
void flag(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (const auto value = readBoolean(element, sink)) plan.*member = *value;
}

void service(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (const auto name = readWord(element, sink)) plan.services.push_back(*name);
}

template <PropertyFilePlan::Mode mode>
void propertyFile(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (const auto file = readWord(element, sink)) plan.propertyFiles.push_back(PropertyFilePlan{mode, *file});
}

template <ScriptPlan::Kind kind>
void script(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (const auto file = readWord(element, sink)) plan.scripts.push_back(ScriptPlan{kind, *file});
}

void properties(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (readProperties(element, sink)) plan.properties.push_back(std::move(element));
}

void ports(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (!requireStruct(element, sink)) return;
    for (const xml::Element& child : element.children) {
        if (child.name == "description") continue;
        const Text port = nameOf(child);
        const auto connection = readString(child, sink);
        if (port.empty())
            sink.error(child.where, "DEP003", "an element of 'Ports' has no name, expected that of a port");
        else if (connection && connection->empty())
            sink.error(child.where, "DEP003",
                       "port '" + port.value + "' has an empty <value>, expected the name of a connection");
        else if (connection)
            plan.ports.push_back(PortPlan{port, *connection});
    }
}

template <std::vector<Text> ComponentPlan::*member>
void names(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (!requireStruct(element, sink)) return;
    for (const xml::Element& child : element.children)
        if (child.name != "description")
            if (const auto name = readWord(child, sink)) (plan.*member).push_back(*name);
}

void activity(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    if (!requireStruct(element, sink)) return;
    if (plan.activity)
        sink.warning(element.where, "DEP013",
                     "a second activity for component '" + plan.name.value + "', which replaces the first")
            .note(plan.activity->where, "the first is here");
    plan.activity = readActivity(element, sink);
}

void server(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    flag<&ComponentPlan::server>(element, plan, sink);
    plan.serverWhere = element.where;
}

void withoutEffect(xml::Element& element, ComponentPlan&, diag::Sink& sink) {
    const std::string name = nameOf(element).value;
    sink.warning(element.where, "DEP019",
                 "'" + name + "' has no effect here; " +
                     (name == "Master" ? "it belongs into the Activity struct" : "it is a property of the deployer"));
}

struct Entry {
    const char* name;
    Reader read;
};

const Entry kEntries[] = {
    {"Activity", activity},
    {"AutoConf", flag<&ComponentPlan::autoConf>},
    {"AutoConnect", flag<&ComponentPlan::autoConnect>},
    {"AutoSave", flag<&ComponentPlan::autoSave>},
    {"AutoStart", flag<&ComponentPlan::autoStart>},
    {"AutoUnload", withoutEffect},
    {"LoadProperties", propertyFile<PropertyFilePlan::Load>},
    {"Master", withoutEffect},
    {"Members", names<&ComponentPlan::members>},
    {"Peers", names<&ComponentPlan::peers>},
    {"Plugin", service},
    {"Ports", ports},
    {"ProgramScript", script<ScriptPlan::Program>},
    {"Properties", properties},
    {"PropertyFile", propertyFile<PropertyFilePlan::Strict>},
    {"Provides", service},
    {"RunScript", script<ScriptPlan::Run>},
    {"Server", server},
    {"Service", service},
    {"StateMachineScript", script<ScriptPlan::StateMachine>},
    {"UpdateProperties", propertyFile<PropertyFilePlan::Update>},
    {"UseNamingService", flag<&ComponentPlan::useNamingService>},
};

void readElement(xml::Element& element, ComponentPlan& plan, diag::Sink& sink) {
    const Text name = nameOf(element);
    if (name.value == "PropFile") {
        sink.error(name.where, "DEP006", "'PropFile' is an old name; please write 'PropertyFile'");
        return;
    }
    std::vector<std::string> known;
    for (const Entry& entry : kEntries) {
        if (name.value == entry.name) return entry.read(element, plan, sink);
        known.push_back(entry.name);
    }
    sink.error(name.where, "DEP006",
               "unknown element '" + name.value + "' in component '" + plan.name.value + "'" +
                   diag::didYouMean(name.value, known));
}

}  // namespace

bool readProperties(const xml::Element& element, diag::Sink& sink) {
    if (!requireStruct(element, sink)) return false;
    for (const xml::Element& child : element.children)
        if (child.name != "description" && nameOf(child).empty())
            sink.error(child.where, "DEP003", "an element of 'Properties' has no name, expected that of a property");
    checkTwice(element, {}, sink);
    for (const xml::Element& child : element.children) RTT::marsh::checkProperty(child, sink);
    return true;
}

ComponentPlan readComponent(xml::Element&& element, diag::Sink& sink) {
    ComponentPlan plan;
    plan.name = nameOf(element);
    plan.type = typeOf(element);
    checkTwice(element, {"AutoConf", "AutoConnect", "AutoSave", "AutoStart"}, sink);
    for (xml::Element& child : element.children)
        if (child.name != "description") readElement(child, plan, sink);
    return plan;
}

}  // namespace OCL::deploy
