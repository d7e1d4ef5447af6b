// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a script that is only looked through would make and connect, for the graph of components.
#ifndef OROFORGE_DEPLOYMENT_FORESEEN_HPP
#define OROFORGE_DEPLOYMENT_FORESEEN_HPP

#include <string>
#include <vector>

namespace OCL::deploy {

/** In words that stand in the script. What a branch or a loop does is not certain. */
struct Foreseen {
    struct Component {
        std::string name;
        std::string type;  // empty: computed
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
    std::vector<std::string> computed;  // "connect() in app.ops:7", whose names the script computes
};

}  // namespace OCL::deploy

#endif
