// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_DEPLOYED_FILES_HPP
#define OROFORGE_DEPLOYMENT_DEPLOYED_FILES_HPP

#include "named_components.hpp"

namespace OCL::deploy {

/** The deployer's operations on files, each of which is a group of components. They report why they return false. */
class DeployedFiles {
public:
    explicit DeployedFiles(Session& session) : session_(session) {}

    /** Loads a file as the next group; undoes that if there is an error. */
    bool load(const std::string& file);
    bool loadText(const std::string& text);
    /** Only prepares a file, after those that were planned before. */
    bool plan(const std::string& file);
    /** Forgets what files say about components and connections; components stay. */
    void forget();
    bool configureAll();
    bool startAll();
    /** Takes a step with all components that files created, the last first; `toDo` is what it does to them. */
    bool forAllDown(const char* toDo, bool (*step)(Session&, int));
    /** Loads and configures a file, and starts its components; undoes all of it if one step fails. */
    bool kickStart(const std::string& file, bool starts);
    bool kickOutAll();
    /** Kicks out the components that the file names. */
    void kickOut(const std::string& file, NamedComponents& components);

    bool valid = false;  ///< the last configuration, see startAll()

private:
    /** What a file changes, apart from creating components. */
    struct State {
        std::list<ComponentRecord> records;
        std::map<std::string, PolicyPlan> policies;
    };
    State state() const { return {session_.records.all, session_.records.policies}; }
    /** Removes what a group created, and restores the state from before its file. */
    void undo(int group, const State& before);

    bool load(const Plan& plan, diag::Sink& sink);
    bool configure(int group);
    bool start(int group);

    Session& session_;
};

}  // namespace OCL::deploy

#endif
