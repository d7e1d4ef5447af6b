// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The effects of operations that scripts call, and which of their arguments name components.
#ifndef OROFORGE_DEPLOYMENT_CALL_EFFECTS_HPP
#define OROFORGE_DEPLOYMENT_CALL_EFFECTS_HPP

#include <cstddef>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

/** A possible effect of an operation of the deployer. */
enum class Effect {
    None,
    Import,
    Path,
    Library,
    Component,
    Peers,
    Service,
    Require,
    Change,     ///< changes the state of a component, which executes its code
    ChangeAll,  ///< the same for all
    Unload,
    UnloadAll,
    Description,  ///< a file that describes components
    Script,
    Wiring,
    Anything
};

/** An argument that begins with the name of a component. */
struct NamedArgument {
    enum Kind { Component, Port, Path };  ///< "arm", "arm.speed", "arm.service.operation"
    std::size_t argument;
    Kind kind = Component;
};

struct CallEffect {
    Effect effect;
    std::vector<NamedArgument> names;
};

/** The effect of an operation of the deployer; Anything for other names. */
const CallEffect& effectOf(const std::string& operation);

/** True for {"print", "ln"}, {"os", "sleep"} and the like: global services whose operations load nothing. */
bool isHarmless(const std::vector<std::string>& path);

/** True if the path leads from the component to an operation that executes no code of users. */
bool isQuery(RTT::TaskContext& component, const std::vector<std::string>& path);

}  // namespace OCL::deploy

#endif
