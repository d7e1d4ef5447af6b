// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_SCRIPT_SYNTAX_HPP
#define ORO_SCRIPTING_SCRIPT_SYNTAX_HPP

#include <rtt/rtt-config.h>

#include <string>

namespace oroforge::diag {
class Sink;
}

namespace RTT::scripting::detail {

/** What a script may contain. */
enum class Contents { Everything, Programs, StateMachines };

/** Reports that a script file cannot be read, or all of its syntax errors. */
RTT_API void checkSyntax(const std::string& file, oroforge::diag::Sink& sink);

/** Also reports errors that do not depend on the component, which has that name and does not exist: for example a
    transition to an unknown state. Not real-time safe; executes nothing. */
RTT_API void checkAlone(const std::string& file, const std::string& component, Contents contents,
                        oroforge::diag::Sink& sink);

}  // namespace RTT::scripting::detail

#endif
