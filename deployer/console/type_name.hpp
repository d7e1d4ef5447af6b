// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_TYPE_NAME_HPP
#define OROFORGE_CONSOLE_TYPE_NAME_HPP

#include <rtt/types/Types.hpp>

#include <string>

namespace OCL::console {

/** The name of a type as scripts write it: "pkg.Type" of "/pkg/Type". */
inline std::string dotted(const std::string& type) { return RTT::types::Types()->toDot(type); }

}  // namespace OCL::console

#endif
