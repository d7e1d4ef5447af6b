// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Type names with variables: "/Eigen/Vector${N}d".
#ifndef OROFORGE_GENERATOR_ADAPTERS_NAME_PATTERN_HPP
#define OROFORGE_GENERATOR_ADAPTERS_NAME_PATTERN_HPP

#include <map>
#include <string>
#include <vector>

namespace oroforge::adapters {

struct NamePart {
    std::string text;  ///< the name of a variable
    bool isVariable = false;
};

/// Splits a pattern into "$N", "${N}" and the text between. A '$' without a name is a variable without a name.
std::vector<NamePart> partsOf(const std::string& pattern);

/// Returns the pattern with its variables replaced.
std::string expanded(const std::string& pattern, const std::map<std::string, std::string>& variables);

}  // namespace oroforge::adapters

#endif
