// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "activities.hpp"
#include "chains.hpp"
#include "properties.hpp"
#include "scripts.hpp"
#include "session.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>

#include <algorithm>
#include <exception>
#include <vector>

namespace OCL::deploy {
namespace {

bool isUp(const RTT::TaskContext& component) { return component.getTaskState() > RTT::TaskContext::Stopped; }

/** The components with options of this group that can be changed now, in file order. */
std::vector<ComponentRecord*> recordsToConfigure(Session& session, int group) {
    std::vector<ComponentRecord*> result;
    for (ComponentRecord& record : session.records.all) {
        if (record.optionsGroup != group) continue;
        if (record.isRemote && !record.plan.autoConf.value_or(false)) continue;  // its own deployer configures it
        if (isUp(*record.instance))
            RTT::log(RTT::Warning) << "component '" << record.name << "' is not configured: it is running"
                                   << RTT::endlog();
        else
            result.push_back(&record);
    }
    return result;
}

void setActivityOf(Session& session, ComponentRecord& record, diag::Sink& sink) {
    const ActivityPlan& plan = *record.plan.activity;
    RTT::TaskContext* master = plan.master.empty() ? nullptr : session.component(plan.master.value);
    std::string error;
    if (!changeActivity(session, *record.instance, plan.kind, numbersOf(plan), master, error))
        sink.error(plan.where, "DEP054",
                   "could not set the " + plan.type + " of component '" + record.name + "': " + error);
}

bool waitsForMaster(const ComponentRecord& record, const std::vector<ComponentRecord*>& pending) {
    const std::string& master = record.plan.activity->master.value;
    return !master.empty() && std::any_of(pending.begin(), pending.end(), [&](const ComponentRecord* other) {
        return other != &record && other->name == master;
    });
}

/** Sets the activities of masters before those of their slaves, which refer to them, whatever their order in the
    file. */
void setActivities(Session& session, const std::vector<ComponentRecord*>& records, diag::Sink& sink) {
    std::vector<ComponentRecord*> pending;
    std::copy_if(records.begin(), records.end(), std::back_inserter(pending),
                 [](const ComponentRecord* record) { return record->plan.activity.has_value(); });
    while (!pending.empty()) {
        const auto next = std::find_if(pending.begin(), pending.end(), [&](const ComponentRecord* record) {
            return !waitsForMaster(*record, pending);
        });
        if (next == pending.end()) {
            for (const ComponentRecord* record : pending)
                sink.error(record->plan.activity->master.where, "DEP017",
                           "component '" + record->name + "' is, through its masters, its own master");
            return;
        }
        setActivityOf(session, **next, sink);
        pending.erase(next);
    }
}

/** Those of another process get their values whatever their state. */
void applyRemoteProperties(Session& session, int group, diag::Sink& sink) {
    for (ComponentRecord& record : session.records.all)
        if (record.isRemote && record.optionsGroup == group && !record.plan.autoConf.value_or(false))
            applyProperties(session, record, sink);
}

void runScripts(ComponentRecord& record, diag::Sink& sink) {
    const std::vector<ScriptPlan> scripts = record.plan.scripts;  // a copy: they may load files that add to the plan
    for (const ScriptPlan& script : scripts) {
        std::string error;
        if (!runScript(record, script, error))
            sink.error(script.file.where, "DEP053",
                       "could not run script '" + script.file.value + "' in component '" + record.name +
                           "': " + (error.empty() ? "the log says why" : error));
    }
}

void configureOne(ComponentRecord& record, diag::Sink& sink) {
    std::string error = "configure() returned false";
    try {
        if (record.instance->configure()) {
            RTT::log(RTT::Info) << "configured component '" << record.name << "'" << RTT::endlog();
            return;
        }
    } catch (const std::exception& thrown) {
        error = std::string("configure() threw: ") + thrown.what();
    }
    if (record.instance->inException()) error = "configure() threw, see the log";
    sink.error(record.plan.name.where, "DEP050", "could not configure component '" + record.name + "': " + error);
}

void startOne(ComponentRecord& record, diag::Sink& sink) {
    std::string error = "start() returned false";
    try {
        if (record.instance->start()) {
            RTT::log(RTT::Info) << "started component '" << record.name << "'" << RTT::endlog();
            return;
        }
    } catch (const std::exception& thrown) {
        error = std::string("start() threw: ") + thrown.what();
    }
    if (record.instance->inException())
        error = "start() threw, see the log";
    else if (!record.instance->isConfigured())
        error = "it is not configured; set AutoConf to have that done";
    sink.error(record.plan.name.where, "DEP051", "could not start component '" + record.name + "': " + error);
}

void stopIfStarted(const ComponentRecord& record, const diag::Location& by, diag::Sink& sink) {
    if (!record.instance->isRunning()) return;
    const diag::Location& where = record.plan.name.where;
    sink.warning(
        where.line != 0 ? where : by, "DEP059",
        "component '" + record.name + "' was started by the code of a component, and is stopped: this is a check");
    (void)stopOne(*record.instance);
}

}  // namespace

void stopWhatStarted(Session& session, const diag::Location& by, diag::Sink& sink) {
    if (!session.startsNothing) return;
    for (const ComponentRecord& record : session.records.all)
        if (record.instance != session.deployer && !record.isRemote) stopIfStarted(record, by, sink);
}

bool configure(Session& session, int group, diag::Sink& sink) {
    checkComponents(session, group, false, sink);
    if (sink.hadErrors()) return false;
    addPeers(session, group, sink);
    connectPorts(session, sink);
    connectSameNames(session, group, sink);

    const std::vector<ComponentRecord*> records = recordsToConfigure(session, group);
    setActivities(session, records, sink);
    setMembers(session, records, sink);
    for (ComponentRecord* record : records) applyProperties(session, *record, sink);
    if (!session.startsNothing) applyRemoteProperties(session, group, sink);
    if (sink.hadErrors()) return false;
    struct Component {
        const RTT::TaskContext* instance;
        bool wasConfigured;
    };
    std::vector<Component> components;
    for (const ComponentRecord* record : records)
        components.push_back({record->instance, record->instance->isConfigured()});
    diag::Location last;
    for (const auto& [component, wasConfigured] : components) {
        ComponentRecord* record = session.records.find(component);
        if (!record) continue;  // a script unloaded it
        last = record->plan.name.where;
        if (!record->plan.scripts.empty()) {
            const diag::Location script = record->plan.scripts.front().file.where;
            runScripts(*record, sink);
            stopWhatStarted(session, script, sink);
            record = session.records.find(component);
            if (!record) continue;
        }
        // Its own scripts, or scripts and hooks of other components, may have configured and started it.
        const bool isDone = isUp(*component) || (!wasConfigured && component->isConfigured());
        if (record->plan.autoConf.value_or(false) && !isDone) configureOne(*record, sink);
        if (session.startsNothing && component != session.deployer) stopIfStarted(*record, last, sink);
    }
    stopWhatStarted(session, last, sink);  // components that code of others started
    if (sink.hadErrors()) return false;

    // Connects ports that appeared while components were configured.
    checkComponents(session, group, true, sink);
    if (sink.hadErrors()) return false;
    connectPorts(session, sink);
    createStreams(session, sink);
    return !sink.hadErrors();
}

bool start(Session& session, int group, diag::Sink& sink) {
    for (ComponentRecord& record : session.records.all)
        if (record.optionsGroup == group && record.plan.autoStart.value_or(false) && !isUp(*record.instance))
            startOne(record, sink);
    return !sink.hadErrors();
}

}  // namespace OCL::deploy
