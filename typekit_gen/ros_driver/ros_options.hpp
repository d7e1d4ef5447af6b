// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Command line of typegen-ros.
#ifndef OROFORGE_TYPEKIT_GEN_ROS_DRIVER_ROS_OPTIONS_HPP
#define OROFORGE_TYPEKIT_GEN_ROS_DRIVER_ROS_OPTIONS_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::messages {

enum class Command { Messages, Services, Md5, Definition, Dependencies, Explain, Help, Version };

struct RosOptions {
    Command command = Command::Help;
    std::vector<std::string> words;  ///< package and files, names, or codes
    std::string output;
    std::vector<std::pair<std::string, std::string>> paths;  ///< package → folder with .msg files
    std::vector<std::string> includes;
    std::size_t perSource = 0;  ///< 0: the default
    std::string depfile;
    std::string depfileTarget;
    bool listOutputs = false;
};

/// Returns nothing, after errors RM008, if the words are not a valid command line.
std::optional<RosOptions> parseRosOptions(const std::vector<std::string>& words, diag::Sink& sink);

std::string rosUsage();

}  // namespace oroforge::messages

#endif
