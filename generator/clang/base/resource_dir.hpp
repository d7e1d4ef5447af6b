// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_BASE_RESOURCE_DIR_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_RESOURCE_DIR_HPP

#include <optional>
#include <string>

#include <diag/sink.hpp>

namespace oroforge::cxx {

/// Returns the folder of clang's builtin headers (the parent of include/stddef.h); nothing after an error TK005.
std::optional<std::string> findResourceDir(const std::string& wanted, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
