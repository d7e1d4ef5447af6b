// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A script with what it is to say: whatever follows `//=` in its lines, in this order.
#ifndef OROFORGE_TESTS_SCRIPTING_CORPUS_FILE_HPP
#define OROFORGE_TESTS_SCRIPTING_CORPUS_FILE_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace scripting_corpus {

/** Names of the scripts in that folder of the corpus, without extension. */
std::vector<std::string> corpusNames(const std::string& folder);
std::filesystem::path corpusPath(const std::string& folder, const std::string& name);

/** The texts after `//=`, without the blank that follows it. */
std::vector<std::string> expectedNotes(const std::string& script);

}  // namespace scripting_corpus

#endif
