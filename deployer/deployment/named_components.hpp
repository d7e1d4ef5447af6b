// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_NAMED_COMPONENTS_HPP
#define OROFORGE_DEPLOYMENT_NAMED_COMPONENTS_HPP

#include "activities.hpp"
#include "session.hpp"

#include <string>
#include <vector>

namespace OCL::deploy {

/** The deployer's operations on one component, which is given by its name. They report why they return false. */
class NamedComponents {
public:
    explicit NamedComponents(Session& session) : session_(session) {}

    bool load(const std::string& name, const std::string& type);
    bool unload(const std::string& name);
    bool loadService(const std::string& name, const std::string& service);
    bool configure(const std::string& name);
    bool start(const std::string& name);
    bool stop(const std::string& name);
    bool cleanup(const std::string& name);
    /** Stops, cleans up and unloads it as far as possible; false only if the deployer has not loaded it. */
    bool kickOut(const std::string& name);
    /** Sets the activity of a component that does not run; a slave may have a master. */
    bool setActivity(const std::string& name, ActivityKind kind, const ActivityNumbers& numbers,
                     RTT::TaskContext* master = nullptr);
    bool setSlaveOf(const std::string& master, const std::string& slave);
    bool chain(const std::string& name, const ActivityNumbers& numbers, const std::vector<std::string>& members);
    /** ORO_WAIT_ABS or ORO_WAIT_REL, for the thread that the component has. */
    bool setWaitPeriodPolicy(const std::string& name, int policy);

private:
    Session& session_;
};

}  // namespace OCL::deploy

#endif
