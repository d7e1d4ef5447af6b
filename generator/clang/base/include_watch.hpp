// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which files include which, and which words stand in those of the user.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_INCLUDE_WATCH_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_INCLUDE_WATCH_HPP

#include <set>
#include <string>
#include <vector>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

struct Word {
    const clang::IdentifierInfo* name;
    clang::SourceLocation at;
};

/// A file that was read, however often.
struct ReadFile {
    bool isUser = false;             ///< no header of the system
    std::set<std::size_t> includes;  ///< directly
    std::set<std::size_t> macros;    ///< where macros that it uses, or asks for, are defined
    std::vector<Word> words;         ///< of the user's: all that may name something; not what follows "." or "->"
};

/// Files are known by a number, in the order in which they were first seen. To be told of each token by the caller.
class IncludeWatch {
public:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// To be called before anything is read; this has to live as long.
    void watch(clang::Preprocessor& preprocessor);
    void take(const clang::Token& token);
    /// C++ that stands in a text, as in [[oro::make("…")]].
    void addWords(const std::string& text, clang::SourceLocation at);

    const std::vector<ReadFile>& files() const { return files_; }
    /// kNone for what is in no file.
    std::size_t fileOf(clang::SourceLocation at) const;
    std::size_t fileCalled(const std::string& path) const;

private:
    class Callbacks;
    std::size_t number(clang::FileID file);
    std::size_t number(const clang::FileEntry& entry);
    void noteInclude(clang::SourceLocation at, clang::OptionalFileEntryRef file);
    void noteMacro(const clang::Token& name, const clang::MacroDefinition& definition);

    clang::Preprocessor* preprocessor_ = nullptr;
    std::vector<ReadFile> files_;
    llvm::DenseMap<const clang::FileEntry*, std::size_t> numbers_;  // looked up only
    clang::FileID current_;
    std::size_t currentNumber_ = kNone;
    bool behindDot_ = false;
};

}  // namespace oroforge::cxx

#endif
