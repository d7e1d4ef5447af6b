// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Golden tests: one directory below tests/golden/<kind>/ is one case.
///
///     class Manifest : public testing::TestWithParam<std::string> {};
///     TEST_P(Manifest, GivesThisModel) {
///         const auto dir = goldenDir("manifest_model", GetParam());
///         expectGolden(dir / "expected/model.json", dump(parse(dir / "input.xml")));
///     }
///     INSTANTIATE_TEST_SUITE_P(Golden, Manifest, testing::ValuesIn(goldenCases("manifest_model")), caseName);
///
/// A difference fails the test with a unified diff and the command that accepts the new text.
/// With UPDATE_GOLDENS=1 the files are rewritten instead; refused when CI=true.
#ifndef OROFORGE_TESTS_SUPPORT_GOLDEN_HPP
#define OROFORGE_TESTS_SUPPORT_GOLDEN_HPP

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "text_diff.hpp"

namespace oroforge::test {

/// Root of the source tree.
std::filesystem::path sourceRoot();

/// Names of the case directories of one kind, sorted. Without those whose file `needs` names a path, one a line, that is not
/// on this machine.
std::vector<std::string> goldenCases(const std::string& kind);
std::filesystem::path goldenDir(const std::string& kind, const std::string& name);

/// Compares line by line; a missing file counts as empty.
void expectGolden(const std::filesystem::path& expected, const std::string& actual);

/// Compares a set of files (relative name → text) with the directory `expected`: no file missing, none left over.
void expectGoldenTree(const std::filesystem::path& expected, const std::map<std::string, std::string>& actual);

/// All files below `dir`, relative name → text.
std::map<std::string, std::string> readTree(const std::filesystem::path& dir);

/// Every occurrence of `what` replaced, to take machine paths out of texts before comparing.
std::string replaceAll(std::string text, const std::string& what, const std::string& with);

/// Letters, digits and '_' only, as GoogleTest wants parameter names.
std::string caseName(const testing::TestParamInfo<std::string>& info);

}  // namespace oroforge::test

#endif
