// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Runs clang over one source of a package: reads the bodies of the package's own functions and skips all others.
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_SOURCE_RUN_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_SOURCE_RUN_HPP

#include <map>
#include <string>
#include <vector>

#include <clang/base/llvm_compat.hpp>
#include <diag/diagnostic.hpp>

namespace oroforge::cxx {

struct SourceRun {
    std::string root;                                 ///< the package: an absolute path without links or '/' at the end
    std::string file;                                 ///< the source, relative to it
    std::string shown;                                ///< goes before file names in messages: "" or "tank/"
    std::vector<std::string> flags;                   ///< -I -isystem -D …, each word one element
    std::map<std::string, std::string> virtualFiles;  ///< absolute path → text; takes precedence over files on disk
    std::string behind;                               ///< C++ that is read after the source
    std::string resourceDir;                          ///< clang's own headers
};

/// Why the compiler did not understand a text.
struct CompileMessage {
    enum Kind {
        Syntax,       ///< the words are not C++, so braces may not mean what they seem to
        MissingFile,  ///< an #include that was not found
        Meaning       ///< any other: unknown names, wrong types
    };
    Kind kind = Meaning;
    diag::Location where;  ///< without a line if it is not in a file of the package
    std::string text;
};

/// The caller's work on the source.
class SourceVisitor {
public:
    virtual ~SourceVisitor() = default;
    /// Called before the first word is read.
    virtual void begin(clang::Preprocessor&) {}
    /// Called after the last word.
    virtual void visit(clang::Sema& sema) = 0;
};

/// Finds places in the files of the package.
class PackagePlaces {
public:
    PackagePlaces(const clang::SourceManager& sources, const SourceRun& run);

    /// Returns the name relative to the package; "" for a file outside it.
    std::string fileOf(clang::SourceLocation at) const;
    /// Returns the place that the user sees; nothing if it is not in the package.
    diag::Location locate(clang::SourceLocation at) const;
    /// Returns bytes from the start of the file. `at` must not be in a macro.
    std::size_t offset(clang::SourceLocation at) const;
    /// True in the text that the run put after the source.
    bool isBehind(clang::SourceLocation at) const;

private:
    const clang::SourceManager& sources_;
    const SourceRun& run_;
    std::size_t sourceSize_;
};

/// Returns false, after a message, if the compiler could not be started.
bool runOnSource(const SourceRun& run, SourceVisitor& visitor, std::vector<CompileMessage>& messages);

}  // namespace oroforge::cxx

#endif
