// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Runs clang once over a text, and reads some function bodies. The caller decides what to do with the result.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_PARSE_FILES_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_PARSE_FILES_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

struct Parse {
    std::string mainFile;                      ///< its text is in `files` or on disk
    std::map<std::string, std::string> files;  ///< name → text; takes precedence over files on disk
    std::vector<std::string> flags;            ///< -I -isystem -D …, each word one element
    std::string resourceDir;                   ///< clang's own headers
    clang::DiagnosticConsumer* messages = nullptr;
    /// True for bodies to skip; those of constexpr functions, and of called 'auto' functions, are always read.
    std::function<bool(clang::Decl&)> skipsBody;
    std::function<void(clang::CompilerInstance&)> begin = nullptr;  ///< called before the first word is read
    std::function<void(const clang::Token&)> word = nullptr;        ///< called for each word as it is read
    std::function<void(clang::Sema&)> end;                          ///< called after the last word
};

/// Returns false if the compiler could not be started; `messages` may say why. Runs everything, callbacks included, in
/// a thread with a large stack; text that is nested too deeply even for that is an error.
bool parseFiles(const Parse& parse);

/// True for code that says nothing about a user's class: the standard library, boost, RTT, or a system header.
bool isLibrary(const clang::Decl& declaration);

}  // namespace oroforge::cxx

#endif
