// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_SYNTAX_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_SYNTAX_HPP

#include <rtt/rtt-config.h>

#include <diag/sink.hpp>

#include <string>

namespace RTT {
namespace scripting {
namespace detail {

/** Reports what can be told of a script file without the component that it is for: that it cannot be read, or its syntax
    errors, all of them. */
RTT_API void checkSyntax(const std::string& file, oroforge::diag::Sink& sink);

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
