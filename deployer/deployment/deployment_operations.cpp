// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations on single components: life cycle, activities.
#include "activities.hpp"
#include "component_name.hpp"
#include "deployment_state.hpp"
#include "failure.hpp"
#include "lookup.hpp"

#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/ThreadInterface.hpp>
#include <rtt/os/threads.hpp>

namespace OCL {

using deploy::ActivityKind;
using deploy::ActivityNumbers;
using deploy::doneOr;
using deploy::failed;
using deploy::reported;
using RTT::internal::FailureReport;

namespace {

bool change(deploy::Session& session, const std::string& name, ActivityKind kind, const ActivityNumbers& numbers,
            RTT::TaskContext* master = nullptr) {
    RTT::TaskContext* component = deploy::findComponent(session, name, "set the activity");
    if (!component) return false;
    std::string error;
    return deploy::changeActivity(session, *component, kind, numbers, master, error) ||
           failed("could not set the activity of component '" + name + "': " + error);
}

/** Calls a state change, which executes code of the component. */
bool called(RTT::TaskContext& component, bool (RTT::TaskContext::*change)()) {
    const FailureReport::Pause others;
    return (component.*change)();
}

ActivityNumbers numbers(double period, int priority, int scheduler, unsigned affinity = 0) {
    ActivityNumbers result;
    result.period = period;
    result.priority = priority;
    result.scheduler = scheduler;
    result.cpuAffinity = affinity;
    return result;
}

}  // namespace

bool DeploymentComponent::loadComponent(const std::string& name, const std::string& type) {
    if (type == "PropertyBag" || type == "RTT::PropertyBag")
        return false;  // a struct that only adds options; it is not a component type
    std::string error;
    RTT::TaskContext* made = nullptr;
    {
        const FailureReport::Pause others;
        made = deploy::create(impl_->session, name, type, 0, error);
    }
    return made || failed("could not load component '" + deploy::printableName(name) + "': " + error);
}

bool DeploymentComponent::unloadComponent(const std::string& name) {
    const deploy::ComponentRecord* record = impl_->session.records.find(name);
    if (!record || !record->loadedHere)
        return failed("could not unload component '" + name + "': it was not loaded by " + getName());
    return reported("could not unload component '" + name + "'",
                    [&] { return deploy::unloadOne(impl_->session, *record->instance); });
}

bool DeploymentComponent::loadService(const std::string& name, const std::string& service) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, name, "load a service");
    return component && doneOr("could not load service '" + service + "' into component '" + name + "'",
                               [&] { return deploy::loadService(*component, service); });
}

bool DeploymentComponent::configureComponent(const std::string& name) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, name, "configure");
    if (!component) return false;
    return called(*component, &RTT::TaskContext::configure) || failed("could not configure component '" + name + "'");
}

bool DeploymentComponent::startComponent(const std::string& name) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, name, "start");
    if (!component) return false;
    return component->isRunning() || impl_->session.startsNothing || called(*component, &RTT::TaskContext::start) ||
           failed("could not start component '" + name + "'");
}

bool DeploymentComponent::stopComponent(const std::string& name) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, name, "stop");
    return component &&
           reported("could not stop component '" + name + "'", [&] { return deploy::stopOne(*component); });
}

bool DeploymentComponent::cleanupComponent(const std::string& name) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, name, "clean up");
    return component && reported("could not clean up component '" + name + "'",
                                 [&] { return deploy::cleanupOne(impl_->session, *component); });
}

bool DeploymentComponent::setActivity(const std::string& name, double period, int priority, int scheduler) {
    return change(impl_->session, name, ActivityKind::Activity, numbers(period, priority, scheduler));
}

bool DeploymentComponent::setActivityOnCPU(const std::string& name, double period, int priority, int scheduler,
                                           unsigned int cpu) {
    if (cpu >= 32)
        return failed("could not set the activity of component '" + name + "': CPU " + std::to_string(cpu) +
                      ", expected 0 to 31");
    return change(impl_->session, name, ActivityKind::Activity, numbers(period, priority, scheduler, 1u << cpu));
}

bool DeploymentComponent::setPeriodicActivity(const std::string& name, double period, int priority, int scheduler) {
    return change(impl_->session, name, ActivityKind::Periodic, numbers(period, priority, scheduler));
}

bool DeploymentComponent::setFileDescriptorActivity(const std::string& name, double timeout, int priority,
                                                    int scheduler) {
    return change(impl_->session, name, ActivityKind::FileDescriptor, numbers(timeout, priority, scheduler));
}

bool DeploymentComponent::setSequentialActivity(const std::string& name) {
    return change(impl_->session, name, ActivityKind::Sequential, ActivityNumbers());
}

bool DeploymentComponent::setSlaveActivity(const std::string& name, double period) {
    return change(impl_->session, name, ActivityKind::Slave, numbers(period, 0, 0));
}

bool DeploymentComponent::setMasterSlaveActivity(const std::string& master, const std::string& slave) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, master, "use as master");
    return component && change(impl_->session, slave, ActivityKind::Slave, ActivityNumbers(), component);
}

bool DeploymentComponent::setWaitPeriodPolicy(const std::string& name, int policy) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, name, "set the wait policy");
    if (!component) return false;
    if (!component->getActivity() || !component->getActivity()->thread())
        return failed("could not set the wait policy of component '" + name + "': it has no thread");
    component->getActivity()->thread()->setWaitPeriodPolicy(policy);
    return true;
}

}  // namespace OCL
