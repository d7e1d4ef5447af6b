// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Runs clang once over a text, with some function bodies read. What is seen, said and done with it is the caller's.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_PARSE_FILES_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_PARSE_FILES_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

struct Parse {
    std::string mainFile;                      ///< its text is in `files`, or on disk
    std::map<std::string, std::string> files;  ///< name → text; hides what is on disk
    std::vector<std::string> flags;            ///< -I -isystem -D …, each word one element
    std::string resourceDir;                   ///< clang's own headers
    clang::DiagnosticConsumer* messages = nullptr;
    /// Bodies not to be read; those of constexpr functions and of 'auto' functions that are called always are.
    std::function<bool(clang::Decl&)> skipsBody;
    std::function<void(clang::CompilerInstance&)> begin = nullptr;  ///< before the first word is read
    std::function<void(const clang::Token&)> word = nullptr;        ///< each, as it is read
    std::function<void(clang::Sema&)> end;                          ///< behind the last one
};

/// False if the compiler could not be started; `messages` may tell why. Runs, with all that it calls, in a thread with a large
/// stack; texts that are nested too deeply for that are errors.
bool parseFiles(const Parse& parse);

/// A body that tells nothing about a user's class: of the standard library, boost, RTT, or a header of the system.
bool isLibrary(const clang::Decl& declaration);

}  // namespace oroforge::cxx

#endif
