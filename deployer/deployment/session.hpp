// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The state of a deployer and the steps that change it. Each step reports to a sink and goes on as far as it can.
//
//     load: imports → validate → create components and load services
//     configure: check ports → peers → connections → activities → properties → scripts → configure → streams
//     start
//     stop → cleanup → unload, in reverse order of creation
#ifndef OROFORGE_DEPLOYMENT_SESSION_HPP
#define OROFORGE_DEPLOYMENT_SESSION_HPP

#include "foreseen.hpp"
#include "property_files.hpp"
#include "records.hpp"

#include <diag/sink.hpp>
#include <rtt/scripting/check.hpp>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace OCL::deploy {

struct Session {
    RTT::TaskContext* deployer = nullptr;
    ComponentRecords records;
    std::vector<Plan> planned;              // plans that are only checked
    Foreseen foreseen;                      // by scripts that are only checked
    RTT::scripting::Expectations expected;  // from these scripts
    std::shared_ptr<PropertyFiles> propertyFiles = std::make_shared<PropertyFiles>();
    std::set<std::string> masters;                  // components whose activities have, or had, slaves
    std::map<int, RTT::ConnPolicy> formerDefaults;  // the replaced default, by the group that replaced it
    int nextGroup = 1;                              // the group of the next file; 0: components created one by one
    bool startsNothing = false;                     // only checks
    int waitPeriodPolicy = 0;                       // for threads of new activities
    std::function<bool(RTT::TaskContext*)> loaded;  // false refuses the component
    std::function<void(RTT::TaskContext*)> unloaded;
    std::function<bool(RTT::TaskContext&, bool)>
        serve;  // makes a server; empty: other processes cannot call components

    /** The deployer for its own name or "this", else one of its peers; null if there is none. */
    RTT::TaskContext* component(const std::string& name) const;
    /** Names that component() accepts, without "this". */
    std::vector<std::string> componentNames() const;
    bool isDeployer(const std::string& name) const;
    /** The record of a component, created if there is none. The reference is valid until records change. */
    ComponentRecord& recordOf(RTT::TaskContext& component);
};

// load.cpp
/** Imports, replaces library files by their types, and validates; creates nothing. True without errors. With `planOnly`
    the components will never exist, so the descriptions in libraries are all that is known of them. */
bool prepare(const Session& session, Plan& plan, bool planOnly, diag::Sink& sink);
/** Prepares and creates; true without errors. After an error, what was created stays: see takeDown(). */
bool load(Session& session, Plan plan, int group, diag::Sink& sink);
/** Creates one component and makes it a peer of the deployer; null with the reason. */
RTT::TaskContext* create(Session& session, const std::string& name, const std::string& type, int group,
                         std::string& error);
/** The same, even if a replay has what would stand for it. */
RTT::TaskContext* createItself(Session& session, const std::string& name, const std::string& type, int group,
                               std::string& error);
/** Makes the operation "start", by which scripts start the component, do nothing. */
void holdBack(RTT::TaskContext& component);
bool loadService(RTT::TaskContext& component, const std::string& service);

// check_components.cpp
/**
 * Reports connections that cannot be made between the real components, and properties that they do not have. A missing
 * port that a component may still add while it is configured is an error only if `configured`.
 */
void checkComponents(const Session& session, int group, bool configured, diag::Sink& sink);

// check_script.cpp
/** Checks a script, as DeploymentComponent::checkScript() does. `runs`: it is executed afterwards. */
bool checkScript(Session& session, const std::string& file, bool runs);

// connect.cpp
void addPeers(Session& session, int group, diag::Sink& sink);
/** Connects each output of a connection with each input; may be repeated. */
void connectPorts(Session& session, diag::Sink& sink);
void connectSameNames(Session& session, int group, diag::Sink& sink);
/** Creates streams for the connections that have only one port. */
void createStreams(Session& session, diag::Sink& sink);

// configure.cpp
/** In a session that starts nothing: stops components that C++ code started in a constructor or hook, which cannot be
    prevented. Components that no file names are reported at `by`. */
void stopWhatStarted(Session& session, const diag::Location& by, diag::Sink& sink);
bool configure(Session& session, int group, diag::Sink& sink);
bool start(Session& session, int group, diag::Sink& sink);

// take_down.cpp
bool stop(Session& session, int group);
bool cleanup(Session& session, int group);
bool unload(Session& session, int group);
bool stopOne(RTT::TaskContext& component);
bool cleanupOne(Session& session, RTT::TaskContext& component);
bool unloadOne(Session& session, RTT::TaskContext& component);
/** Stops, cleans up and unloads as far as possible, in reverse order of creation; true if nothing of the group is
    left. */
bool takeDown(Session& session, int group);

}  // namespace OCL::deploy

#endif
