// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_CONDITIONAL_WATCH_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_CONDITIONAL_WATCH_HPP

#include <map>
#include <string>

#include <model/user_code.hpp>

#include "source_run.hpp"

namespace oroforge::cxx {

/// Records each #if … #endif in files of the package, and the lines that the compiler skips, while they are read.
void watchConditionals(clang::Preprocessor& preprocessor, const SourceRun& run,
                       std::map<std::string, model::Conditionals>& into);

}  // namespace oroforge::cxx

#endif
