// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_TEXT_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_TEXT_HPP

#include <diag/sink.hpp>

#include <optional>
#include <string>

namespace RTT::scripting::detail {

/** The content of a script file. If it cannot be read, reports why and returns nothing. */
std::optional<std::string> readScript(const std::string& file, oroforge::diag::Sink& sink);

}  // namespace RTT::scripting::detail

#endif
