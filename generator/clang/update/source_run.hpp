// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Runs clang over one source of a package: bodies of the package's own functions are read, all others skipped.
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_SOURCE_RUN_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_SOURCE_RUN_HPP

#include <map>
#include <string>
#include <vector>

#include <clang/base/llvm_compat.hpp>
#include <diag/diagnostic.hpp>

namespace oroforge::cxx {

struct SourceRun {
    std::string root;                                 ///< the package: an absolute path without links, no '/' behind
    std::string file;                                 ///< the source, relative to it
    std::string shown;                                ///< put before names of files in what is reported: "" or "tank/"
    std::vector<std::string> flags;                   ///< -I -isystem -D …, each word one element
    std::map<std::string, std::string> virtualFiles;  ///< absolute path → text; hides what is on disk
    std::string behind;                               ///< C++ that is read behind the source
    std::string resourceDir;                          ///< clang's own headers
};

/// What kept the compiler from understanding a text.
struct CompileMessage {
    enum Kind {
        Syntax,       ///< words that make no C++: braces may not mean what they seem to
        MissingFile,  ///< an #include that was not found
        Meaning       ///< all others: unknown names, wrong types
    };
    Kind kind = Meaning;
    diag::Location where;  ///< without a line if it is not in a file of the package
    std::string text;
};

/// What is done with the source.
class SourceVisitor {
public:
    virtual ~SourceVisitor() = default;
    /// Before the first word is read.
    virtual void begin(clang::Preprocessor&) {}
    /// Behind the last one.
    virtual void visit(clang::Sema& sema) = 0;
};

/// Places in the files of the package.
class PackagePlaces {
public:
    PackagePlaces(const clang::SourceManager& sources, const SourceRun& run);

    /// Name relative to the package, "" if it is a file of somebody else.
    std::string fileOf(clang::SourceLocation at) const;
    /// As the user sees it; nothing if it is not in the package.
    diag::Location locate(clang::SourceLocation at) const;
    /// Bytes from the start of the file. `at` is no place in a macro.
    std::size_t offset(clang::SourceLocation at) const;
    /// In the text that the run put behind the source.
    bool isBehind(clang::SourceLocation at) const;

private:
    const clang::SourceManager& sources_;
    const SourceRun& run_;
    std::size_t sourceSize_;
};

/// False, with a message, if the compiler could not be started.
bool runOnSource(const SourceRun& run, SourceVisitor& visitor, std::vector<CompileMessage>& messages);

}  // namespace oroforge::cxx

#endif
