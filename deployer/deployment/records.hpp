// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The components that a deployer knows, with what files say about them.
#ifndef OROFORGE_DEPLOYMENT_RECORDS_HPP
#define OROFORGE_DEPLOYMENT_RECORDS_HPP

#include "plan.hpp"

#include <list>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

/** What a script loaded into its component. */
struct LoadedScript {
    ScriptPlan script;
    std::vector<std::string> programs, machines;
};

struct ComponentRecord {
    std::string name;
    RTT::TaskContext* instance = nullptr;
    bool isRemote = false;  // a component of another process, which the end of this one leaves alone
    std::shared_ptr<RTT::TaskContext> standIn;  // instance, if a recording stands for the component
    bool loadedHere = false;                    // false for the deployer itself and for peers that others created
    int group = 0;                              // the group that created it
    int optionsGroup = 0;                       // the group that last gave it options and applies them
    ComponentPlan plan;
    std::string master;                // the component whose activity executes this one; empty if it is not a slave
    Text loadedFile;                   // the last property file that was applied, which AutoSave writes
    std::vector<LoadedScript> loaded;  // in the order in which the scripts ran
};

/** A connection, with its ports from all files. */
struct Connection {
    std::string name;
    RTT::ConnPolicy policy;
    struct Member {
        const ComponentRecord* record;
        const PortPlan* plan;
    };
    std::vector<Member> members;  // in the order of the files, never empty
};

/** True if both come from the same statement of the same file, whatever the name of the file. */
bool isSameStatement(const ScriptPlan& a, const ScriptPlan& b);

struct ComponentRecords {
    ComponentRecords() = default;
    ComponentRecords(const ComponentRecords&) = delete;
    ComponentRecords& operator=(const ComponentRecords&) = delete;

    // In order of creation. A list, because scripts add components while others are configured. Use add() and erase().
    std::list<ComponentRecord> all;
    std::map<std::string, PolicyPlan> policies;  // by connection name

    ComponentRecord& add(const std::string& name, RTT::TaskContext* instance);
    void erase(const RTT::TaskContext* instance);
    ComponentRecord* find(const std::string& name);
    ComponentRecord* find(const RTT::TaskContext* instance);
    /** Adds the options of another struct: flags and the activity are replaced, lists grow. */
    static void merge(ComponentPlan& known, const ComponentPlan& more);
    /** All connections, in the order of their first ports. Pointers are valid until records change. */
    std::vector<Connection> connections() const;

private:
    std::unordered_map<const RTT::TaskContext*, std::list<ComponentRecord>::iterator> places_;
};

}  // namespace OCL::deploy

#endif
