// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components that a replay puts in the place of those whose ports were recorded.
#ifndef OROFORGE_DEPLOYMENT_REPLACED_HPP
#define OROFORGE_DEPLOYMENT_REPLACED_HPP

#include "plan.hpp"

#include <diag/sink.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

struct ComponentRecord;
struct Session;

/** The ports in a recording. */
class RecordedPorts {
public:
    virtual ~RecordedPorts() = default;
    virtual bool hasComponent(const std::string& component) const = 0;
    virtual bool hasPort(const std::string& component, const std::string& port) const = 0;
    /** Those of the component, "service.port" for those of services. */
    virtual std::vector<std::string> portsOf(const std::string& component) const = 0;
    /** Whether users want this component to be replaced; none if that is left to its ports. */
    virtual std::optional<bool> isWanted(const std::string& component) const = 0;
    /** Adds the recorded output ports to what stands for the component of that name. `problems` gets, by port, why one
        is missing. */
    virtual void addPorts(RTT::TaskContext& component, std::map<std::string, std::string>& problems) = 0;
};

/** From now on, all deployers of this process replace components; null: none. Not owned. */
void setRecordedPorts(RecordedPorts* ports);
/** Null outside of a replay. */
RecordedPorts* recordedPorts();

/**
 * Marks the components of a plan that are replaced, and removes from it what they cannot have: properties, services,
 * scripts, and an activity. A component is replaced if the recording has all of its connected ports, and so none of
 * them is an input, or if users want it; and so is a recorder, which would write over the recording. If neither files
 * nor libraries tell of an input, and its type is known, a component is made and asked. Reports connected outputs that
 * the recording lacks, and what users want to be replaced, but runs.
 */
void replaceRecorded(const Session& session, Plan& plan, diag::Sink& sink);

/** For a component that a script creates: how it is replaced. */
ComponentPlan planOf(const std::string& name, const std::string& type);

/** True in a replay, which begins when the scripts have ended: the log says that the operation does not wait. */
bool replaysInstead(const char* operation);

/** True if a recording stands for it. */
bool isStandIn(const RTT::TaskContext& component);

/** Makes what stands for the component, as create() does; or itself, if it turns out that it has an input. Reports
    ports that it lacks: as errors at those in the plan, as a warning in the log otherwise. Null, with the reason, if
    the name is taken. */
RTT::TaskContext* createStandIn(Session& session, ComponentPlan& component, int group, diag::Sink& sink,
                                std::string& error);

}  // namespace OCL::deploy

#endif
