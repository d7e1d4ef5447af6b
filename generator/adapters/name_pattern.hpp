// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Names of types with variables in them: "/Eigen/Vector${N}d".
#ifndef OROFORGE_GENERATOR_ADAPTERS_NAME_PATTERN_HPP
#define OROFORGE_GENERATOR_ADAPTERS_NAME_PATTERN_HPP

#include <map>
#include <string>
#include <vector>

namespace oroforge::adapters {

struct NamePart {
    std::string text;  ///< of a variable, its name
    bool isVariable = false;
};

/// Of "$N" and "${N}", and what is between them. A '$' without a name behind it is a variable without a name.
std::vector<NamePart> partsOf(const std::string& pattern);

/// With the variables replaced.
std::string expanded(const std::string& pattern, const std::map<std::string, std::string>& variables);

}  // namespace oroforge::adapters

#endif
