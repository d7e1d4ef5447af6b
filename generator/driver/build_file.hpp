// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds places in the user's CMakeLists.txt, outside comments and quotes.
#ifndef OROFORGE_GENERATOR_DRIVER_BUILD_FILE_HPP
#define OROFORGE_GENERATOR_DRIVER_BUILD_FILE_HPP

#include <cstddef>
#include <optional>
#include <string>

namespace oroforge::driver {

inline constexpr const char* kBuildFile = "CMakeLists.txt";

struct Command {
    std::size_t begin = 0;  ///< of its line
    std::size_t close = 0;  ///< of its closing parenthesis
    std::string first;      ///< its first argument
};

std::optional<Command> findCommand(const std::string& cmake, const std::string& name);

/// Returns where file names end among the arguments: before the first keyword, such as DEPENDS.
std::size_t endOfNames(const std::string& cmake, const Command& call);

/// Inserts `fresh` after the argument `known` of some command: in a line of its own if `known` has one, else beside it.
/// Returns false if there is no such argument.
bool addBehind(std::string& cmake, const std::string& known, const std::string& fresh);

}  // namespace oroforge::driver

#endif
