// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "named_components.hpp"

#include "chains.hpp"
#include "component_name.hpp"
#include "failure.hpp"
#include "lookup.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/ThreadInterface.hpp>

namespace OCL::deploy {

using RTT::internal::FailureReport;

namespace {

/** Calls a state change, which executes code of the component. */
bool called(RTT::TaskContext& component, bool (RTT::TaskContext::*change)()) {
    const FailureReport::Pause others;
    return (component.*change)();
}

}  // namespace

bool NamedComponents::load(const std::string& name, const std::string& type) {
    if (type == "PropertyBag" || type == "RTT::PropertyBag")
        return false;  // a struct that only adds options; it is not a component type
    std::string error;
    RTT::TaskContext* made = nullptr;
    {
        const FailureReport::Pause others;
        made = create(session_, name, type, 0, error);
    }
    return made || failed("could not load component '" + printableName(name) + "': " + error);
}

bool NamedComponents::unload(const std::string& name) {
    const ComponentRecord* record = session_.records.find(name);
    if (!record || !record->loadedHere)
        return failed("could not unload component '" + name + "': it was not loaded by " +
                      session_.deployer->getName());
    return reported("could not unload component '" + name + "'",
                    [&] { return unloadOne(session_, *record->instance); });
}

bool NamedComponents::loadService(const std::string& name, const std::string& service) {
    RTT::TaskContext* component = findComponent(session_, name, "load a service");
    return component && doneOr("could not load service '" + service + "' into component '" + name + "'",
                               [&] { return deploy::loadService(*component, service); });
}

bool NamedComponents::configure(const std::string& name) {
    RTT::TaskContext* component = findComponent(session_, name, "configure");
    if (!component) return false;
    return called(*component, &RTT::TaskContext::configure) || failed("could not configure component '" + name + "'");
}

bool NamedComponents::start(const std::string& name) {
    RTT::TaskContext* component = findComponent(session_, name, "start");
    if (!component) return false;
    return component->isRunning() || session_.startsNothing || called(*component, &RTT::TaskContext::start) ||
           failed("could not start component '" + name + "'");
}

bool NamedComponents::stop(const std::string& name) {
    RTT::TaskContext* component = findComponent(session_, name, "stop");
    return component && reported("could not stop component '" + name + "'", [&] { return stopOne(*component); });
}

bool NamedComponents::cleanup(const std::string& name) {
    RTT::TaskContext* component = findComponent(session_, name, "clean up");
    return component &&
           reported("could not clean up component '" + name + "'", [&] { return cleanupOne(session_, *component); });
}

bool NamedComponents::kickOut(const std::string& name) {
    const ComponentRecord* record = session_.records.find(name);
    if (!record || !record->loadedHere)
        return failed("could not kick out component '" + name + "': it was not loaded by " +
                      session_.deployer->getName());
    const FailureReport::Pause others;
    RTT::TaskContext& component = *record->instance;
    if (!record->isRemote) {
        (void)stopOne(component);
        (void)cleanupOne(session_, component);
    }
    (void)unloadOne(session_, component);
    return true;
}

bool NamedComponents::setActivity(const std::string& name, ActivityKind kind, const ActivityNumbers& numbers,
                                  RTT::TaskContext* master) {
    RTT::TaskContext* component = findComponent(session_, name, "set the activity");
    if (!component) return false;
    std::string error;
    return changeActivity(session_, *component, kind, numbers, master, error) ||
           failed("could not set the activity of component '" + name + "': " + error);
}

bool NamedComponents::setSlaveOf(const std::string& master, const std::string& slave) {
    RTT::TaskContext* component = findComponent(session_, master, "use as master");
    return component && setActivity(slave, ActivityKind::Slave, {}, component);
}

bool NamedComponents::chain(const std::string& name, const ActivityNumbers& numbers,
                            const std::vector<std::string>& members) {
    std::string error;
    bool done = false;
    {
        const FailureReport::Pause others;
        done = makeChain(session_, name, numbers, members, error);
    }
    return done || failed("could not make chain '" + printableName(name) + "': " + error);
}

bool NamedComponents::setWaitPeriodPolicy(const std::string& name, int policy) {
    RTT::TaskContext* component = findComponent(session_, name, "set the wait policy");
    if (!component) return false;
    if (!component->getActivity() || !component->getActivity()->thread())
        return failed("could not set the wait policy of component '" + name + "': it has no thread");
    component->getActivity()->thread()->setWaitPeriodPolicy(policy);
    return true;
}

}  // namespace OCL::deploy
