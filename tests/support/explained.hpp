// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Tests of the texts that explain the codes of diagnostics: generator/explain/, deployer/explain/.
#ifndef OROFORGE_TESTS_SUPPORT_EXPLAINED_HPP
#define OROFORGE_TESTS_SUPPORT_EXPLAINED_HPP

#include <diag/explain.hpp>

#include <set>
#include <string>
#include <vector>

namespace oroforge::test {

/// What a folder of the source tree explains.
diag::Explanations explanationsIn(const std::string& folder);

std::vector<std::string> codesOf(const diag::Explanations& explanations);

/// Those that have such a block which is no command ("$ …").
std::vector<std::string> codesWith(const std::string& title, const diag::Explanations& explanations);

/// The indented lines below a line such as "Example:", without the indentation.
std::string block(const diag::Explanation& explanation, const std::string& title);

/// Fails the test for every quoted code in the sources of these folders that has no explanation, and for every explanation
/// whose code is in none of them. `prefixes` is what codes begin with: "OM|OC".
void expectExplained(const diag::Explanations& explanations, const std::vector<std::string>& folders,
                     const std::string& prefixes);

/// Fails the test unless there are a title and a paragraph, in lines that fit on a screen.
void expectReadable(const diag::Explanation& explanation);

}  // namespace oroforge::test

#endif
