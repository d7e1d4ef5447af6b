// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Records which files include which, and the words in those of the user.
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

/// A file that was read, once or several times.
struct ReadFile {
    bool isUser = false;             ///< not a system header
    std::set<std::size_t> includes;  ///< directly
    std::set<std::size_t> macros;    ///< files that define the macros that it uses or tests
    std::vector<Word> words;         ///< in user files, all that may name something; not after "." or "->"
};

/// Numbers files in the order in which they are first seen. The caller passes each token on.
class IncludeWatch {
public:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// Call it before anything is read; this object must outlive the preprocessor.
    void watch(clang::Preprocessor& preprocessor);
    void take(const clang::Token& token);
    /// Adds C++ in a string, as in [[oro::make("…")]].
    void addWords(const std::string& text, clang::SourceLocation at);

    const std::vector<ReadFile>& files() const { return files_; }
    /// Returns kNone for a place that is in no file.
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
