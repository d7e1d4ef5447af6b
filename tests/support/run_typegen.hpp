// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// typegen within the test's own process: quicker than a program of its own, and a debugger is there already.
/// The test links oroforge_typekit_gen; header-only, so that other users of this folder need not.
#ifndef OROFORGE_TESTS_SUPPORT_RUN_TYPEGEN_HPP
#define OROFORGE_TESTS_SUPPORT_RUN_TYPEGEN_HPP

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include <driver/typegen.hpp>

namespace oroforge::test {

struct Ran {
    int status;
    std::string out;
    std::string err;
};

/// With these words of a command line.
inline Ran runTypegen(const std::vector<std::string>& words) {
    std::ostringstream out, err;
    const int status = typekit::run(words, out, err);
    return {status, out.str(), err.str()};
}

/// Command line of a golden case: the lines of its file `args`.
inline std::vector<std::string> wordsOf(const std::filesystem::path& dir) {
    std::vector<std::string> words;
    std::ifstream file(dir / "args");
    for (std::string line; std::getline(file, line);) words.push_back(line);
    return words;
}

/// In the folder `dir`, as cases of golden tests are run; `words` come before those of the case.
/// It changes the current folder of the process, so no other thread may use relative paths meanwhile.
inline Ran runTypegenIn(const std::filesystem::path& dir, std::vector<std::string> words) {
    for (std::string& word : wordsOf(dir)) words.push_back(std::move(word));
    struct Return {
        const std::filesystem::path before = std::filesystem::current_path();
        ~Return() {
            std::error_code ignored;  // what throws in a destructor would end the program
            std::filesystem::current_path(before, ignored);
        }
    } const whenDone;
    std::filesystem::current_path(dir);
    return runTypegen(words);
}

}  // namespace oroforge::test

#endif
