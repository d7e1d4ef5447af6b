// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_PLAN_METHODS_HPP
#define OROFORGE_GENERATOR_MERGE_PLAN_METHODS_HPP

#include <merge/plan.hpp>

namespace oroforge::merge {

/// Plans operations and hooks of one class.
void planMethods(const WantedClass& wanted, const model::UserClass& type, const Input& input, Plan& into,
                 diag::Sink& sink);

/// True if the function in the code has this signature, as the compiler sees it; if it could not see it, as written.
bool hasSignature(const model::UserFunction& function, const model::Signature& signature, const std::string& className,
                  const Input& input);

/// Returns the signature as the user wrote it: "bool finish(double sent)".
std::string asWritten(const model::UserFunction& function, const model::UserCode& code);

/// Warns that the user removed "operation" or "port" `shown`.
void warnRemoved(const model::UserClass& type, const std::string& kind, const std::string& shown,
                 const diag::Location& where, diag::Sink& sink);

}  // namespace oroforge::merge

#endif
