// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_ARGUMENT_LIST_HPP
#define OROFORGE_GENERATOR_MERGE_ARGUMENT_LIST_HPP

#include <string>
#include <vector>

#include <model/user_code.hpp>

namespace oroforge::merge {

struct NewArguments {
    std::string text;   ///< of what stands between the brackets
    std::string fault;  ///< why it cannot be done; empty if it can
};

/// The argument list of `function` after a change from `from` to `to`. Arguments that stay keep the user's name, comments,
/// default value and line breaks; what the user wrote beside an argument that goes is a fault. Names of new arguments
/// are commented out where the body does not use them yet.
NewArguments changedArguments(const std::string& text, const model::UserFunction& function,
                              const std::vector<model::TypedName>& from, const std::vector<model::TypedName>& to,
                              bool commentNames);

/// For each of `to` the one of `from` that it goes on from, or -1.
std::vector<int> matchArguments(const std::vector<model::TypedName>& from, const std::vector<model::TypedName>& to);

}  // namespace oroforge::merge

#endif
