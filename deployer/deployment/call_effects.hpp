// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the operations that a script calls will do, and which of their arguments name components: for the check of the
// script before it is executed.
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
    None,         ///< nothing that a check must know
    Import,       ///< loads the plugins and component libraries of a package
    Path,         ///< adds to the path of packages
    Library,      ///< loads a library
    Component,    ///< makes a component
    Peers,        ///< makes components peers
    Service,      ///< loads a service into a component
    Require,      ///< loads a global service, or fails
    Change,       ///< changes the state of a component; that executes its hooks
    ChangeAll,    ///< the same for all components
    Unload,       ///< a component exists no more, or not under this name
    UnloadAll,    ///< the same for all components
    Description,  ///< loads a file that describes components
    Script,       ///< executes another script
    Wiring,       ///< connects ports, services or operations
    Anything      ///< cannot be told
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

/** The effect of an operation of the deployer; None for one that all components have and that only queries. */
const CallEffect& effectOf(const std::string& operation);

/** True for {"print", "ln"}, {"os", "sleep"} and the like: global services whose operations load nothing. */
bool isHarmless(const std::vector<std::string>& path);

/** True if the path leads from the component to an operation that executes no code of users. */
bool isQuery(RTT::TaskContext& component, const std::vector<std::string>& path);

}  // namespace OCL::deploy

#endif
