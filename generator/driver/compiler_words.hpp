// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Options of a compiler on our command line: written as compilers have them, which no option parser understands.
#ifndef OROFORGE_GENERATOR_DRIVER_COMPILER_WORDS_HPP
#define OROFORGE_GENERATOR_DRIVER_COMPILER_WORDS_HPP

#include <string>
#include <vector>

namespace oroforge::driver {

/// Takes -I -isystem -D -U -include (each followed by its value, or with it) and -std= out of the words. An option without a
/// value stays, to be refused.
std::vector<std::string> takeCompilerWords(std::vector<std::string>& words);

}  // namespace oroforge::driver

#endif
