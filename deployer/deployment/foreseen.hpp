// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a checked script would create and connect, for the graph of components.
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
    };
    struct Join {
        enum Kind { Ports, SamePorts, Stream, Peer } kind;
        std::string one;
        std::string two;  // empty for a stream
        bool certain;
    };

    std::vector<Component> components;
    std::vector<Join> joins;
    std::vector<std::string> computed;  // calls such as "connect() in app.ops:7" whose names the script computes
};

}  // namespace OCL::deploy

#endif
