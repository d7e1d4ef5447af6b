// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The components a deployer knows and what files said about them.
#ifndef OROFORGE_DEPLOYMENT_RECORDS_HPP
#define OROFORGE_DEPLOYMENT_RECORDS_HPP

#include "plan.hpp"

#include <list>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

/** What a script has left in its component. */
struct LoadedScript {
    ScriptPlan script;
    std::vector<std::string> programs, machines;
};

struct Record {
    std::string name;
    RTT::TaskContext* instance = nullptr;
    bool loadedHere = false;  // else: the deployer itself or a peer that others made
    int group = 0;            // that created it
    int optionsGroup = 0;     // that last gave it options: these are applied with that group
    ComponentPlan plan;
    std::string master;                // whose activity executes this component; empty: none
    Text loadedFile;                   // the last property file that was applied; AutoSave writes it
    std::vector<LoadedScript> loaded;  // in the order in which the scripts ran
};

/** One connection: the ports of all files that name it. */
struct Connection {
    std::string name;
    RTT::ConnPolicy policy;
    struct Member {
        const Record* record;
        const PortPlan* plan;
    };
    std::vector<Member> members;  // in the order of the files, never empty
};

/** True if both are one statement of one file, whatever the file was called. */
bool isSameStatement(const ScriptPlan& a, const ScriptPlan& b);

struct Records {
    Records() = default;
    Records(const Records&) = delete;
    Records& operator=(const Records&) = delete;

    // In order of creation. A list, because scripts add while others are configured; they come and go by add() and erase().
    std::list<Record> all;
    std::map<std::string, PolicyPlan> policies;  // by connection name

    Record& add(const std::string& name, RTT::TaskContext* instance);
    void erase(const RTT::TaskContext* instance);
    Record* find(const std::string& name);
    Record* find(const RTT::TaskContext* instance);
    /** Adds what a struct says to what was said before: flags and the activity replace, lists grow. */
    static void merge(ComponentPlan& known, const ComponentPlan& more);
    /** All connections, in the order in which their first port is named. Pointers hold until records change. */
    std::vector<Connection> connections() const;

private:
    std::unordered_map<const RTT::TaskContext*, std::list<Record>::iterator> places_;
};

}  // namespace OCL::deploy

#endif
