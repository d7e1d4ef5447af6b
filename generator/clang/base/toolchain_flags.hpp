// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Where the compiler finds <rtt/…>, without the user's help.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_TOOLCHAIN_FLAGS_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_TOOLCHAIN_FLAGS_HPP

#include <string>
#include <vector>

namespace oroforge::cxx {

/// -isystem options for the headers that belong to the program `executable`: in include/ beside its bin/, or, of a program
/// in a build tree, in the sources that tree was made from. None if neither is there, or the compiler looks there anyway.
std::vector<std::string> toolchainFlags(const std::string& executable);

/// The same for the program that runs.
std::vector<std::string> toolchainFlags();

/// Those whose folders `flags` do not name: a folder that the user names stays the user's.
std::vector<std::string> toolchainFlagsBesides(const std::vector<std::string>& flags);

}  // namespace oroforge::cxx

#endif
