// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "activities.hpp"

#include "session.hpp"

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/FileDescriptorActivity.hpp>
#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/engine/other_order.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/threads.hpp>

#include <limits>
#include <memory>
#include <set>
#include <string>

namespace OCL::deploy {
namespace {

using RTT::base::ActivityInterface;

std::unique_ptr<ActivityInterface> fileDescriptorActivity(RTT::TaskContext& component, const ActivityNumbers& n,
                                                          std::string& error) {
    if (n.period > std::numeric_limits<int>::max()) {
        error = "the timeout is too large, expected milliseconds";
        return nullptr;
    }
    auto activity = std::make_unique<RTT::extras::FileDescriptorActivity>(n.scheduler, n.priority, n.period / 1000,
                                                                          n.cpuAffinity, nullptr, component.getName());
    activity->setTimeout(static_cast<int>(n.period));
    return activity;
}

std::unique_ptr<ActivityInterface> makeActivity(RTT::TaskContext& component, ActivityKind kind,
                                                const ActivityNumbers& n, RTT::TaskContext* master,
                                                std::string& error) {
    switch (kind) {
        case ActivityKind::Activity:
            return std::make_unique<RTT::Activity>(n.scheduler, n.priority, n.period, n.cpuAffinity, nullptr,
                                                   component.getName());
        case ActivityKind::NonPeriodic:
            return std::make_unique<RTT::Activity>(n.scheduler, n.priority, 0.0, n.cpuAffinity, nullptr,
                                                   component.getName());
        case ActivityKind::Periodic:
            if (n.period > 0)
                return std::make_unique<RTT::extras::PeriodicActivity>(n.scheduler, n.priority, n.period, n.cpuAffinity,
                                                                       nullptr);
            error = "a PeriodicActivity needs a period of more than 0";
            return nullptr;
        case ActivityKind::Sequential: return std::make_unique<RTT::extras::SequentialActivity>();
        case ActivityKind::FileDescriptor: return fileDescriptorActivity(component, n, error);
        case ActivityKind::Slave:
            if (!master) return std::make_unique<RTT::extras::SlaveActivity>(n.period);
            if (master->getActivity()) return std::make_unique<RTT::extras::SlaveActivity>(master->getActivity());
            error = "master '" + master->getName() + "' has no activity";
            return nullptr;
    }
    return nullptr;
}

/** Why `master` cannot be the master of the component; empty if it can. */
std::string whyNoMaster(Session& session, const RTT::TaskContext& component, const RTT::TaskContext& master) {
    if (&master == &component) return "it would be its own master";
    std::set<std::string> seen;
    for (std::string name = master.getName(); !name.empty() && seen.insert(name).second;) {
        const ComponentRecord* const record = session.records.find(name);
        name = record ? record->master : std::string();
        if (name == component.getName()) return "through its masters it would be its own master";
    }
    return {};
}

/** The slaves of a component. They refer to its activity, so code that replaces or deletes that must handle them
    first. */
std::vector<ComponentRecord*> slavesOf(Session& session, const std::string& master) {
    std::vector<ComponentRecord*> slaves;
    if (session.masters.count(master) == 0) return slaves;
    for (ComponentRecord& record : session.records.all)
        if (record.master == master) slaves.push_back(&record);
    return slaves;
}

/** A slave while its master has no activity for it. */
struct Released {
    RTT::TaskContext* slave;
    RTT::TaskContext* master;
    bool wasRunning;
};

/** A slave refers to the activity of its master, so none may exist while that is exchanged: gives the slaves of the
    component, and theirs, another one, the innermost first. Those that run are stopped. */
bool release(Session& session, RTT::TaskContext& master, std::vector<Released>& released, std::string& error) {
    for (const ComponentRecord* record : slavesOf(session, master.getName())) {
        RTT::TaskContext& slave = *record->instance;
        if (!release(session, slave, released, error)) return false;
        std::string reason;
        const bool wasRunning = slave.isRunning();
        if (wasRunning) (void)stopOne(slave);
        if (!setActivity(slave, ActivityKind::Sequential, ActivityNumbers(), nullptr, 0, reason)) {
            error = "its slave '" + record->name + "' does not let go of the present one: " + reason;
            if (wasRunning && !slave.isRunning()) (void)slave.start();
            return false;
        }
        released.push_back({&slave, &master, wasRunning});
    }
    return true;
}

/** Makes them slaves again, the outermost first, because the others need their activities. */
void attach(const std::vector<Released>& released) {
    for (auto one = released.rbegin(); one != released.rend(); ++one) {
        std::string reason;
        if (!setActivity(*one->slave, ActivityKind::Slave, ActivityNumbers(), one->master, 0, reason))
            RTT::log(RTT::Error) << "component '" << one->slave->getName() << "' is no longer a slave of '"
                                 << one->master->getName() << "': " << reason << RTT::endlog();
    }
    for (const Released& one : released) {
        if (!one.wasRunning || one.slave->isRunning()) continue;
        if (one.slave->start())
            RTT::log(RTT::Info) << "component '" << one.slave->getName()
                                << "' was stopped and started to exchange the activity of its master '"
                                << one.master->getName() << "'" << RTT::endlog();
        else
            RTT::log(RTT::Error) << "component '" << one.slave->getName()
                                 << "' was stopped to exchange the activity of its master '" << one.master->getName()
                                 << "', and does not start again" << RTT::endlog();
    }
}

}  // namespace

ActivityNumbers numbersOf(const ActivityPlan& plan) {
    ActivityNumbers numbers;
    numbers.period = plan.period.value_or(0.0);
    numbers.priority = plan.priority.value_or(RTT::os::LowestPriority);
    numbers.scheduler = plan.realTime ? ORO_SCHED_RT : ORO_SCHED_OTHER;
    numbers.cpuAffinity = plan.cpuAffinity.value_or(0);
    return numbers;
}

bool setActivity(RTT::TaskContext& component, ActivityKind kind, const ActivityNumbers& numbers,
                 RTT::TaskContext* master, int waitPolicy, std::string& error) {
    if (component.isRunning()) {
        error = "the component is running";
        return false;
    }
    if (!(numbers.period >= 0)) {
        error = "the period is negative, or no number";
        return false;
    }
    std::unique_ptr<ActivityInterface> activity = makeActivity(component, kind, numbers, master, error);
    if (!activity) return false;
    const bool ownThread =
        kind == ActivityKind::Activity || kind == ActivityKind::NonPeriodic || kind == ActivityKind::FileDescriptor;
    if (ownThread && activity->thread()) activity->thread()->setWaitPeriodPolicy(waitPolicy);
    if (!component.setActivity(activity.release())) {  // the component owns it, even if it refuses
        error = "the component does not accept it; it cannot be set from the component's own thread";
        return false;
    }
    // A replay executes in the order of these, whether or not this user may have them for threads.
    if (ownThread && RTT::internal::OtherOrder::installed())
        (void)component.getActivity()->thread()->setPriority(numbers.priority);
    if (master && master != &component && !master->hasPeer(component.getName()))
        master->addPeer(&component);  // code of the master finds its slaves among its peers
    return true;
}

bool changeActivity(Session& session, RTT::TaskContext& component, ActivityKind kind, const ActivityNumbers& numbers,
                    RTT::TaskContext* master, std::string& error) {
    if (component.isRunning()) {
        error = "the component is running";
        return false;
    }
    if (master) error = whyNoMaster(session, component, *master);
    if (!error.empty()) return false;
    std::vector<Released> released;
    const bool changed = release(session, component, released, error) &&
                         setActivity(component, kind, numbers, master, session.waitPeriodPolicy, error);
    attach(released);
    if (changed) session.recordOf(component).master = master ? master->getName() : std::string();
    if (changed && master) session.masters.insert(master->getName());
    return changed;
}

void releaseSlaves(Session& session, const RTT::TaskContext& master) {
    for (ComponentRecord* slave : slavesOf(session, master.getName())) {
        std::string error;
        if (slave->instance->isRunning())
            RTT::log(RTT::Error) << "component '" << slave->name << "' is stopped: its master '" << master.getName()
                                 << "' is being deleted" << RTT::endlog();
        (void)stopOne(*slave->instance);
        // It may have slaves itself.
        if (changeActivity(session, *slave->instance, ActivityKind::Sequential, ActivityNumbers(), nullptr, error))
            RTT::log(RTT::Info) << "component '" << slave->name << "' has lost its master '" << master.getName() << "'"
                                << RTT::endlog();
        slave->master.clear();
    }
}

}  // namespace OCL::deploy
