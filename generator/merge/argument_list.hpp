// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_ARGUMENT_LIST_HPP
#define OROFORGE_GENERATOR_MERGE_ARGUMENT_LIST_HPP

#include <string>
#include <vector>

#include <model/user_code.hpp>

namespace oroforge::merge {

struct NewArguments {
    std::string text;   ///< new text between the brackets
    std::string fault;  ///< why the list cannot be changed; empty if it can
};

/// Returns the argument list of `function` after a change from `from` to `to`. Kept arguments keep the user's name,
/// comments, default value and line breaks; a comment beside a removed argument is a fault. Names of new arguments are
/// commented out where the body does not use them yet.
NewArguments changedArguments(const std::string& text, const model::UserFunction& function,
                              const std::vector<model::TypedName>& from, const std::vector<model::TypedName>& to,
                              bool commentNames);

/// Returns, for each of `to`, the index in `from` of the argument that it continues, or -1.
std::vector<int> matchArguments(const std::vector<model::TypedName>& from, const std::vector<model::TypedName>& to);

}  // namespace oroforge::merge

#endif
