// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a checked script would create and connect, for the graph of components and the list of chains.
#ifndef OROFORGE_DEPLOYMENT_FORESEEN_HPP
#define OROFORGE_DEPLOYMENT_FORESEEN_HPP

#include <string>
#include <vector>

namespace OCL::deploy {

/** What a script would do, in its own words. The effects of branches and loops are not certain. */
struct Foreseen {
    struct Component {
        std::string name;
        std::string type;  // empty if the script computes it
        bool certain;
        std::string where;  // "app.ops:7"
    };
    struct Join {
        enum Kind { Ports, SamePorts, Stream, Peer } kind;
        std::string one;
        std::string two;  // empty for a stream
        bool certain;
    };

    /** A chain, or a thread: what chain() and setActivity() say of it. */
    struct Thread {
        std::string component;
        std::string text;   // "ORO_SCHED_OTHER, priority 0, period 0.01 s"
        std::string where;  // "app.ops:7"
        bool certain;
    };
    struct Chain {
        Thread thread;
        std::vector<std::string> members;
        bool computed;  // the members, by the script
    };
    struct Slave {
        std::string master;
        std::string name;
        bool certain;
    };

    std::vector<Chain> chains;    // of chain()
    std::vector<Thread> threads;  // of setActivity()
    std::vector<Slave> slaves;    // of setMasterSlaveActivity()
    std::vector<Component> components;
    std::vector<Join> joins;
    std::vector<std::string> computed;  // calls such as "connect() in app.ops:7" whose names the script computes
};

}  // namespace OCL::deploy

#endif
