// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "activities.hpp"
#include "properties.hpp"
#include "session.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>

#include <exception>
#include <memory>
#include <vector>

namespace OCL::deploy {
namespace {

enum class Which { All, OfThisProcess };

/** The components that this group created, the last first. Not records, because unloading changes them. */
std::vector<RTT::TaskContext*> created(const Session& session, int group, Which which) {
    std::vector<RTT::TaskContext*> result;
    for (auto record = session.records.all.rbegin(); record != session.records.all.rend(); ++record)
        if (record->loadedHere && record->group == group && (which == Which::All || !record->isRemote))
            result.push_back(record->instance);
    return result;
}

/** Calls a state change of a component; an exception counts as failure. */
bool succeeds(RTT::TaskContext& component, bool (RTT::TaskContext::*change)(), const char* name) {
    try {
        return (component.*change)();
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Error) << name << "() of component '" << component.getName() << "' threw: " << thrown.what()
                             << RTT::endlog();
        return false;
    }
}

/** What this thread executes of the component, which must not be deleted meanwhile; null for nothing. */
const char* executing(const RTT::TaskContext& component) {
    using RTT::internal::HookInProgress;
    for (const HookInProgress* hook = HookInProgress::innermost(); hook; hook = hook->outer)
        if (hook->task == &component) return hook->hook;
    return nullptr;
}

}  // namespace

bool stopOne(RTT::TaskContext& component) {
    if (!component.isRunning()) return true;
    if (succeeds(component, &RTT::TaskContext::stop, "stop")) {
        RTT::log(RTT::Info) << "stopped component '" << component.getName() << "'" << RTT::endlog();
        return true;
    }
    RTT::log(RTT::Error) << "could not stop component '" << component.getName() << "'" << RTT::endlog();
    return false;
}

bool cleanupOne(Session& session, RTT::TaskContext& component) {
    if (component.getTaskState() > RTT::TaskContext::Stopped) {
        RTT::log(RTT::Error) << "could not clean up component '" << component.getName() << "': it is running"
                             << RTT::endlog();
        return false;
    }
    if (const ComponentRecord* record = session.records.find(&component)) autoSave(*record);
    // In PreOperational there is nothing to clean up, so false is not a failure.
    (void)succeeds(component, &RTT::TaskContext::cleanup, "cleanup");
    return true;
}

bool unloadOne(Session& session, RTT::TaskContext& component) {
    const std::string name = component.getName();
    const ComponentRecord* const record = session.records.find(&component);
    const bool isRemote = record && record->isRemote;
    if (!isRemote && component.isRunning()) {
        RTT::log(RTT::Error) << "could not unload component '" << name << "': it is running" << RTT::endlog();
        return false;
    }
    if (const char* const what = executing(component)) {
        RTT::log(RTT::Error) << "could not unload component '" << name << "' from within: it is executing " << what
                             << RTT::endlog();
        return false;
    }
    releaseSlaves(session, component);
    session.unloaded(&component);
    if (!isRemote) component.disconnect();
    const std::shared_ptr<RTT::TaskContext> standIn = record ? record->standIn : nullptr;
    session.records.erase(&component);
    if (!standIn && !RTT::ComponentLoader::Instance()->unloadComponent(&component)) return false;
    RTT::log(RTT::Info) << "unloaded component '" << name << "'" << RTT::endlog();
    return true;
}

bool stop(Session& session, int group) {
    bool all = true;
    for (RTT::TaskContext* component : created(session, group, Which::OfThisProcess)) all &= stopOne(*component);
    return all;
}

bool cleanup(Session& session, int group) {
    bool all = true;
    for (RTT::TaskContext* component : created(session, group, Which::OfThisProcess))
        all &= cleanupOne(session, *component);
    return all;
}

bool unload(Session& session, int group) {
    bool all = true;
    for (RTT::TaskContext* component : created(session, group, Which::All)) all &= unloadOne(session, *component);
    return all;
}

bool takeDown(Session& session, int group) {
    const bool stopped = stop(session, group);
    const bool cleaned = cleanup(session, group);
    const bool unloaded = unload(session, group);
    if (stopped && cleaned && unloaded) return true;
    RTT::log(RTT::Critical) << "kicking out group " << group << " failed:" << (stopped ? "" : " stop")
                            << (cleaned ? "" : " cleanup") << (unloaded ? "" : " unload") << RTT::endlog();
    return false;
}

}  // namespace OCL::deploy
