// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_TEXT_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_TEXT_HPP

#include <diag/sink.hpp>

#include <optional>
#include <string>

namespace RTT::scripting::detail {

/** The content of a script file; nothing if it cannot be read, and why in the sink. */
std::optional<std::string> readScript(const std::string& file, oroforge::diag::Sink& sink);

}  // namespace RTT::scripting::detail

#endif
