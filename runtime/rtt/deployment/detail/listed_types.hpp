// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component types that the file of a library lists.
#ifndef OROFORGE_LISTED_TYPES_HPP
#define OROFORGE_LISTED_TYPES_HPP

#include <string>
#include <vector>

namespace RTT::plugin {

/**
 * The names that the macros of Component.hpp have written into section `orocos_types` of the file. Reads a few blocks
 * of the file and executes nothing of it. None if there is no such section, or if the file is damaged.
 */
std::vector<std::string> listedTypes(const std::string& file);

}  // namespace RTT::plugin

#endif
