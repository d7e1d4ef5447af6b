// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_EXPLAIN_HPP
#define OROFORGE_DEPLOYER_EXPLAIN_HPP

#include <diag/explain.hpp>

#include <string>
#include <vector>

namespace OCL::deploy {

class ProgramReport;

/** What the codes of these programs mean: the texts of deployer/explain/. */
const oroforge::diag::Explanations& explanations();

/** Prints what these codes of errors mean, without any a list of all. False if one does not exist. */
bool explain(const std::vector<std::string>& codes, const std::string& program, ProgramReport& report);

}  // namespace OCL::deploy

#endif
