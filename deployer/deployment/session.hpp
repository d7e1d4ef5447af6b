// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One deployer's state and the steps that change it. Each step reports to a sink and goes on as far as it can.
//
//     load: imports → validate → create components and load services
//     configure: check ports → peers → connections → activities → properties → scripts → configure → streams
//     start
//     stop → cleanup → unload, in reverse order of creation
#ifndef OROFORGE_DEPLOYMENT_SESSION_HPP
#define OROFORGE_DEPLOYMENT_SESSION_HPP

#include "foreseen.hpp"
#include "records.hpp"

#include <diag/sink.hpp>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace OCL::deploy {

struct Session {
    RTT::TaskContext* deployer = nullptr;
    Records records;
    std::vector<Plan> planned;                      // that are only to be checked
    Foreseen foreseen;                              // by scripts that are only looked through
    std::set<std::string> masters;                  // whose activities have, or once had, slaves
    std::map<int, RTT::ConnPolicy> formerDefaults;  // by the group that replaced it
    int nextGroup = 1;                              // of the next file; 0: components created one by one
    bool startsNothing = false;                     // it only checks
    int waitPeriodPolicy = 0;                       // for the threads of new activities
    std::function<bool(RTT::TaskContext*)> loaded;  // false refuses the component
    std::function<void(RTT::TaskContext*)> unloaded;

    /** The deployer for its own name or "this", else one of its peers; null if there is none. */
    RTT::TaskContext* component(const std::string& name) const;
    /** Names that component() accepts, without "this". */
    std::vector<std::string> componentNames() const;
    bool isDeployer(const std::string& name) const;
    /** The record of a component, made if there is none. The reference holds until records change. */
    Record& recordOf(RTT::TaskContext& component);
};

// load.cpp
/** Imports, finds the types that library files stand for, and validates; creates nothing. True if nothing was wrong. The
    components of a plan that is only looked at are never seen: then what libraries tell of them is all there is to know. */
bool prepare(const Session& session, Plan& plan, bool planOnly, diag::Sink& sink);
/** Prepares and creates; true if nothing was wrong. What was created stays: see takeDown. */
bool load(Session& session, Plan plan, int group, diag::Sink& sink);
/** The component type that is meant: `word`, or the one type of the library file of that name, which is loaded. The reason
    in `error` if the file cannot be loaded, or has none or several. */
std::string componentTypeOf(const std::string& word, std::string& error);
/** Why no component of that type can be created; empty if the loader has it. */
std::string unknownType(const std::string& type);
/** Creates one component and makes it a peer of the deployer; null with the reason. */
RTT::TaskContext* create(Session& session, const std::string& name, const std::string& type, int group,
                         std::string& error);
/** Takes the effect from the operation "start", by which scripts start a component. */
void holdBack(RTT::TaskContext& component);
bool loadService(RTT::TaskContext& component, const std::string& service);
bool loadLibrary(const std::string& file, std::string& error);
/** Those of a list of directories, separated by colons or semicolons, that are none. */
std::vector<std::string> missingDirectories(const std::string& paths);
/** Adds directories to the search path of components and plugins. */
void addSearchPath(const std::string& paths);
/** Has the search path be what it was before, at the end. */
class KeptSearchPath {
public:
    KeptSearchPath();
    ~KeptSearchPath();
    KeptSearchPath(const KeptSearchPath&) = delete;
    KeptSearchPath& operator=(const KeptSearchPath&) = delete;

private:
    const std::string components_, plugins_;
};

// check_components.cpp
/**
 * Reports connections that cannot be made between the real components, and properties they do not have.
 * A port that a component may still add while it is configured is not missed before `configured`.
 */
void checkComponents(const Session& session, int group, bool configured, diag::Sink& sink);

// connect.cpp
void addPeers(Session& session, int group, diag::Sink& sink);
/** Connects every output of a connection with every input of it; again is harmless. */
void connectPorts(Session& session, diag::Sink& sink);
void connectSameNames(Session& session, int group, diag::Sink& sink);
/** Makes streams of the connections that have one port only. */
void createStreams(Session& session, diag::Sink& sink);

// configure.cpp
/** In a session that starts nothing: stops the components that C++ code started, in a constructor or hook, which nothing can
    keep it from. `by` is told as the place of those that stand in no file. */
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
/** All three, as far as possible, in reverse order of creation; true if nothing of the group is left. */
bool takeDown(Session& session, int group);

}  // namespace OCL::deploy

#endif
