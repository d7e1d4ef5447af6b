// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Takes compiler options from the command line: no option parser understands how compilers write them.
#ifndef OROFORGE_GENERATOR_DRIVER_COMPILER_WORDS_HPP
#define OROFORGE_GENERATOR_DRIVER_COMPILER_WORDS_HPP

#include <string>
#include <vector>

namespace oroforge::driver {

/// Removes -I -isystem -D -U -include (with their values) and -std= from the words, and returns them. An option without
/// a value stays, and is then refused.
std::vector<std::string> takeCompilerWords(std::vector<std::string>& words);

}  // namespace oroforge::driver

#endif
