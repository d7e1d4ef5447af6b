// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_EXPLAIN_HPP
#define OROFORGE_DEPLOYER_EXPLAIN_HPP

#include <string>
#include <vector>

namespace OCL::deploy {

/** Prints what these codes of errors mean (deployer/explain/), without any a list of all. False if one does not exist. */
bool explain(const std::vector<std::string>& codes, const std::string& program);

}  // namespace OCL::deploy

#endif
