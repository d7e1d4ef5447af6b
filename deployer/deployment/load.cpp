// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "component_name.hpp"
#include "libraries.hpp"
#include "properties.hpp"
#include "replaced.hpp"
#include "scripts.hpp"
#include "session.hpp"
#include "validate.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/ComponentDescription.hpp>
#include <rtt/internal/engine/deferred_activity.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <algorithm>
#include <set>

namespace OCL::deploy {
namespace {

using RTT::ComponentLoader;
using RTT::internal::ComponentDescriptions;
using RTT::plugin::PluginLoader;

/** A service with a similar name; none if the service exists but refused to load. */
std::string likelyService(const std::string& name) {
    const std::vector<std::string> all = PluginLoader::Instance()->listServices();
    return std::find(all.begin(), all.end(), name) == all.end() ? diag::didYouMean(name, all) : std::string();
}

/** Adds directories to the search path and imports the libraries directly in them. */
bool importLibrariesIn(const std::string& paths, std::string& error) {
    addSearchPath(paths);
    try {
        if (ComponentLoader::Instance()->import(paths)) return true;
        error = "nothing to import in there";
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    return false;
}

bool doImport(const ImportPlan& step, std::string& error) {
    switch (step.kind) {
        case ImportPlan::Import: return ComponentLoader::Instance()->import(step.what.value, std::string(), error);
        case ImportPlan::Path: return importLibrariesIn(step.what.value, error);
        case ImportPlan::LoadLibrary: return loadLibrary(step.what.value, error);
    }
    return false;
}

/** A component that is replaced needs no library; one that runs, and has none, is an error of its own. */
void reportImport(const ImportPlan& step, const std::string& why, diag::Sink& sink) {
    const std::string text = "could not " + std::string(step.kind == ImportPlan::Import ? "import" : "load") + " '" +
                             step.what.value + "': " + why;
    if (recordedPorts())
        sink.warning(step.what.where, "DEP030", text + "; the replay goes on without it");
    else
        sink.error(step.what.where, "DEP030", text);
}

void doImports(const Plan& plan, diag::Sink& sink) {
    std::set<std::string> imported;  // by the present search path
    for (const ImportPlan& step : plan.imports) {
        std::string error;
        if (step.kind == ImportPlan::Path) imported.clear();
        if (step.kind == ImportPlan::Import && imported.count(step.what.value)) continue;
        if (step.kind == ImportPlan::Path)
            for (const std::string& directory : missingDirectories(step.what.value))
                sink.warning(step.what.where, "DEP030", "there is no directory '" + directory + "' to search");
        if (doImport(step, error)) {
            if (step.kind == ImportPlan::Import) imported.insert(step.what.value);
            continue;
        }
        // A directory of packages is a valid search path, though it has nothing to import itself.
        if (step.kind == ImportPlan::Path)
            RTT::log(RTT::Info) << "Path '" << step.what.value << "': " << error << RTT::endlog();
        else
            reportImport(step, error, sink);
    }
}

/** Replaces library files that are given instead of types by their component type. Reports and returns those that
    failed. */
std::vector<std::string> resolveTypes(Plan& plan, diag::Sink& sink) {
    std::vector<std::string> reported;
    for (ComponentPlan& component : plan.components) {
        if (component.isReplaced) continue;
        std::string error;
        Text& type = component.type;
        type.value = componentTypeOf(type.value, error);
        if (error.empty()) continue;
        sink.error(type.where, "DEP031", error);
        reported.push_back(type.value);
    }
    return reported;
}

/** What libraries tell of the types of a plan. False if a type is unknown, or its library cannot be loaded. */
bool addTypes(const Plan& plan, PlanContext& context) {
    bool all = true;
    for (const ComponentPlan& component : plan.components) {
        const std::string& type = component.type.value;
        const auto create = ComponentLoader::Instance()->factoryOf(type);
        all = all && create;
        if (!create) continue;
        context.componentTypes.push_back(type);
        const auto* described = ComponentDescriptions::find(type, reinterpret_cast<const void*>(create));
        if (described) context.descriptions.emplace(type, described);
    }
    return all;
}

PlanContext surroundingsOf(const Session& session, const Plan& plan) {
    PlanContext result;
    result.deployer = session.deployer->getName();
    result.components = session.deployer->getPeerList();
    for (const Connection& connection : session.records.connections()) result.connections.insert(connection.name);
    for (const Plan& plan : session.planned) result.planned.push_back(&plan);
    // Not the names of all, which would load libraries that nobody needs, unless users get proposals.
    if (!addTypes(plan, result)) result.componentTypes = ComponentLoader::Instance()->listComponentTypes();
    for (const Plan& earlier : session.planned) (void)addTypes(earlier, result);
    result.services = PluginLoader::Instance()->listServices();
    result.propertyFiles = session.propertyFiles;
    result.serves = session.serve != nullptr;
    return result;
}

/** The record that a struct creates or adds to; null if the component could not be made. Part of the plan goes if a
    recording stands for it. */
ComponentRecord* recordFor(Session& session, ComponentPlan& component, int group, diag::Sink& sink) {
    const std::string name =
        session.isDeployer(component.name.value) ? session.deployer->getName() : component.name.value;
    if (RTT::TaskContext* existing = session.component(name)) return &session.recordOf(*existing);
    std::string error;
    const RTT::internal::ActivityFollows follows(component.activity ? name : std::string());  // set later
    const bool isPerhapsReplaced = component.isReplaced || component.isReplacedWithoutInput;
    if (!(isPerhapsReplaced ? createStandIn(session, component, group, sink, error)
                            : createItself(session, name, component.type.value, group, error))) {
        sink.error(component.name.where, "DEP032", "could not create component '" + name + "': " + error);
        return nullptr;
    }
    return &session.records.all.back();
}

/** A component of another process may have another name there, as one that a reference in a file names. */
void addUnderOwnName(Session& session, RTT::TaskContext& component) {
    const std::string own = component.getName();
    if (!session.component(own)) session.deployer->addPeer(&component, own);
}

}  // namespace

RTT::TaskContext* create(Session& session, const std::string& name, const std::string& word, int group,
                         std::string& error) {
    ComponentPlan component = planOf(name, word);
    if (!component.isReplaced && !component.isReplacedWithoutInput)
        return createItself(session, name, word, group, error);
    diag::Sink unused;  // it has no connections that could be reported
    return createStandIn(session, component, group, unused, error);
}

RTT::TaskContext* createItself(Session& session, const std::string& name, const std::string& word, int group,
                               std::string& error) {
    if (name.empty()) {
        error = "its name is empty";
        return nullptr;
    }
    if (const std::string why = nameFault(name); !why.empty()) {
        error = why;
        return nullptr;
    }
    if (session.component(name)) {
        error = "a component of that name is already there";
        return nullptr;
    }
    const std::string type = componentTypeOf(word, error);
    if (!error.empty()) return nullptr;
    RTT::TaskContext* component = ComponentLoader::Instance()->loadComponent(name, type, error);
    if (!component) return nullptr;
    if (!session.loaded(component)) {
        error = "this deployer refuses it";
        ComponentLoader::Instance()->unloadComponent(component);
        return nullptr;
    }
    if (session.startsNothing && !isRemoteType(type)) holdBack(*component);
    session.deployer->addPeer(component, name);
    ComponentRecord& record = session.records.add(name, component);
    record.loadedHere = true;
    record.isRemote = isRemoteType(type);
    addUnderOwnName(session, *component);
    record.plan.type.value = type;
    record.group = record.optionsGroup = group;
    RTT::log(RTT::Info) << "created component '" << name << "' of type " << type << RTT::endlog();
    return component;
}

void holdBack(RTT::TaskContext& component) {
    const RTT::OperationInterfacePart* const own = component.provides()->getPart("start");
    if (own && own->arity() != 0) return;  // it is another operation of that name
    const std::string name = component.getName();
    component.provides()->removeOperation("start");
    component.addOperation("start", [name] {
        RTT::log(RTT::Info) << "component '" << name << "' is not started: this is a check" << RTT::endlog();
        return true;
    });
}

bool prepare(const Session& session, Plan& plan, bool planOnly, diag::Sink& sink) {
    doImports(plan, sink);
    replaceRecorded(session, plan, sink);
    const std::vector<std::string> reported = resolveTypes(plan, sink);
    PlanContext around = surroundingsOf(session, plan);
    around.planOnly = planOnly;
    around.luaFault = [&session](const std::string& file) { return luaFault(*session.deployer, file); };
    around.componentTypes.insert(around.componentTypes.end(), reported.begin(), reported.end());
    for (const ComponentPlan& component : plan.components)
        if (component.isReplaced) around.componentTypes.push_back(component.type.value);
    validate(plan, around, sink);
    return !sink.hadErrors();
}

bool load(Session& session, Plan plan, int group, diag::Sink& sink) {
    if (!prepare(session, plan, /*planOnly=*/false, sink)) return false;
    for (const PolicyPlan& policy : plan.policies) session.records.policies[policy.name.value] = policy;
    if (plan.defaultPolicy) {
        session.formerDefaults.emplace(group, RTT::ConnPolicy::Default());
        RTT::ConnPolicy::Default() = *plan.defaultPolicy;
    }
    applyGlobals(plan.globals, sink);
    for (ComponentPlan& component : plan.components) {
        ComponentRecord* record = recordFor(session, component, group, sink);
        if (!record) continue;
        record->optionsGroup = group;
        ComponentRecords::merge(record->plan, component);
        if (component.server.value_or(false) && session.serve && !session.startsNothing &&
            !session.serve(*record->instance, component.useNamingService.value_or(true)))
            sink.error(component.serverWhere, "DEP067",
                       "other processes cannot use component '" + record->name + "'; the log says why");
        for (const Text& service : component.services)
            if (!loadService(*record->instance, service.value))
                sink.error(service.where, "DEP033",
                           "could not load service '" + service.value + "' into component '" + record->name + "'" +
                               likelyService(service.value));
    }
    stopWhatStarted(session, plan.components.empty() ? diag::Location() : plan.components.back().name.where, sink);
    return !sink.hadErrors();
}

bool loadService(RTT::TaskContext& component, const std::string& service) {
    return component.provides()->hasService(service) || PluginLoader::Instance()->loadService(service, &component);
}

}  // namespace OCL::deploy
