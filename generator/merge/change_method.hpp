// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_CHANGE_METHOD_HPP
#define OROFORGE_GENERATOR_MERGE_CHANGE_METHOD_HPP

#include <merge/plan.hpp>

namespace oroforge::merge {

/// Gives another signature to a declaration in the class and to its definitions. If a part cannot be edited, reports an
/// error, changes nothing and returns false.
bool changeMethod(const model::UserFunction& declaration, const model::Signature& from, const WantedMethod& method,
                  const model::UserClass& type, const Input& input, Plan& into, diag::Sink& sink);

}  // namespace oroforge::merge

#endif
