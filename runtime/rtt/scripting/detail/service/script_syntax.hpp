// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_SYNTAX_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_SYNTAX_HPP

#include <rtt/rtt-config.h>

#include <diag/sink.hpp>

#include <string>

namespace RTT::scripting::detail {

/** What a text may have. */
enum class Contents { Everything, Programs, StateMachines };

/** Reports what can be told of a script file without the component that it is for: that it cannot be read, or its syntax
    errors, all of them. */
RTT_API void checkSyntax(const std::string& file, oroforge::diag::Sink& sink);

/** Reports more: what is wrong whatever interface the component has that is called so and does not exist, as a transition to a
    state that its machine does not have. Not real-time safe; executes nothing. */
RTT_API void checkAlone(const std::string& file, const std::string& component, Contents contents,
                        oroforge::diag::Sink& sink);

}  // namespace RTT::scripting::detail

#endif
