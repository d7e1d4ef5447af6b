// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// typegen-ros as a function.
#ifndef OROFORGE_TYPEKIT_GEN_ROS_DRIVER_TYPEGEN_ROS_HPP
#define OROFORGE_TYPEKIT_GEN_ROS_DRIVER_TYPEGEN_ROS_HPP

#include <iosfwd>
#include <string>
#include <vector>

namespace oroforge::messages {

/// Parses the words, runs, and prints diagnostics to `err`. Returns the exit status: 0, or 1 after errors.
int runTypegenRos(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

}  // namespace oroforge::messages

#endif
