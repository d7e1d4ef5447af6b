// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds <rtt/…> for the compiler without the user's help.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_TOOLCHAIN_FLAGS_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_TOOLCHAIN_FLAGS_HPP

#include <string>
#include <vector>

namespace oroforge::cxx {

/// Returns -isystem options for the headers of the program `executable`: include/ beside its bin/ or, for a program in
/// a build tree, the sources of that tree. Empty if neither exists, or if the compiler searches there anyway.
std::vector<std::string> toolchainFlags(const std::string& executable);

/// Does the same for the running program.
std::vector<std::string> toolchainFlags();

/// Returns the flags for folders that `flags` does not name: those that the user names stay as they are.
std::vector<std::string> toolchainFlagsBesides(const std::vector<std::string>& flags);

}  // namespace oroforge::cxx

#endif
