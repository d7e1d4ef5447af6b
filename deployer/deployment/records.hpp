// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The components a deployer knows and what files said about them.
#ifndef OROFORGE_DEPLOYMENT_RECORDS_HPP
#define OROFORGE_DEPLOYMENT_RECORDS_HPP

#include "plan.hpp"

#include <list>
#include <map>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

struct Record {
    std::string name;
    RTT::TaskContext* instance = nullptr;
    bool loadedHere = false;  // else: the deployer itself or a peer that others made
    int group = 0;            // that created it
    int optionsGroup = 0;     // that last gave it options: these are applied with that group
    ComponentPlan plan;
    std::string master;  // whose activity executes this component; empty: none
    Text loadedFile;     // the last property file that was applied; AutoSave writes it
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

struct Records {
    std::list<Record> all;  // in order of creation; a list, because scripts add while others are configured
    std::map<std::string, PolicyPlan> policies;  // by connection name

    Record* find(const std::string& name);
    Record* find(const RTT::TaskContext* instance);
    /** False if the record was erased meanwhile. */
    bool has(const Record* record) const;
    /** Adds what a file says to what was said before: flags replace, lists grow. */
    static void merge(ComponentPlan& known, const ComponentPlan& more);
    /** All connections, in the order in which their first port is named. Pointers hold until records change. */
    std::vector<Connection> connections() const;
    void erase(const RTT::TaskContext* instance);
};

}  // namespace OCL::deploy

#endif
