// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_EXPLAIN_HPP
#define OROFORGE_DEPLOYER_EXPLAIN_HPP

#include <diag/explain.hpp>

#include <string>
#include <vector>

namespace OCL::deploy {

class ProgramReport;

/** The explanations of the codes of these programs, from deployer/explain/. */
const oroforge::diag::Explanations& explanations();

/** Prints the explanations of these codes, or a list of all if there are none. False if a code does not exist. */
bool explain(const std::vector<std::string>& codes, const std::string& program, ProgramReport& report);

}  // namespace OCL::deploy

#endif
