// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_CHECK_HPP
#define ORO_SCRIPTING_CHECK_HPP

#include <rtt/rtt-config.h>

#include <iosfwd>
#include <string>

namespace RTT {
class TaskContext;

namespace scripting {

/**
 * Tells what is wrong with a script for `component`, without executing any of it. Messages have the form of a compiler's, and
 * are written to `messages`. True if there are no errors.
 *
 * If its syntax is right, names, types and arguments are looked up: in the component, its peers and services as they are
 * now, and among what the script itself defines. As soon as a statement calls an operation, which may create components,
 * types or services, a name that nobody knows is no error any more; wrong arguments and types still are.
 *
 * While this is being executed nobody else may use the interface of the component, which gets a service for each program and
 * state machine of the script, and loses it at the end. Any thread; not real-time safe; calls no operation.
 */
RTT_API bool checkScript(const std::string& file, TaskContext& component, std::ostream& messages);

/** The same for a text, which messages call `name`. */
RTT_API bool checkScriptText(const std::string& text, const std::string& name, TaskContext& component,
                             std::ostream& messages);

}  // namespace scripting
}  // namespace RTT

#endif
