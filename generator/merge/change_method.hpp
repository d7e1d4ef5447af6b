// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_CHANGE_METHOD_HPP
#define OROFORGE_GENERATOR_MERGE_CHANGE_METHOD_HPP

#include <merge/plan.hpp>

namespace oroforge::merge {

/// Gives a declaration in the class, and the definitions that go with it, another signature. False, with an error, and
/// without any change, if a part of it stands where it cannot be edited.
bool changeMethod(const model::UserFunction& declaration, const model::Signature& from, const WantedMethod& method,
                  const model::UserClass& type, const Input& input, Plan& into, diag::Sink& sink);

}  // namespace oroforge::merge

#endif
