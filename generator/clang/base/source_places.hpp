// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// From clang's locations to those of the user: paths as given on the command line.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_SOURCE_PLACES_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_SOURCE_PLACES_HPP

#include <map>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>
#include <model/type_model.hpp>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// Name of the main file that includes the listed headers; it exists in memory only.
inline constexpr const char* kMainFile = "typegen_input.cpp";

/// The same file without "a/../", "./" and "//", unless that would be another one, behind a link.
std::string plainPath(const std::string& path);

class SourcePlaces {
public:
    /// `program` stands for the main file in messages.
    explicit SourcePlaces(const std::vector<model::Header>& headers, std::string program = "typegen");
    const std::string& program() const { return program_; }

    /// Where the user sees it: for macro expansions the place of the macro's use.
    /// Of what a macro makes: where it stands in the macro, or in its arguments. Unknown if the macro glued it together.
    diag::Location locateWritten(const clang::SourceManager& sources, clang::SourceLocation at) const;
    diag::Location locate(const clang::SourceManager& sources, clang::SourceLocation at) const;

    /// Whether it stands in one of the listed headers.
    bool isListed(const clang::SourceManager& sources, clang::SourceLocation at) const;

    /// The listed header that brought this place in, the first of a chain of #includes; empty if none did.
    std::string listedAbove(const clang::SourceManager& sources, clang::SourceLocation at) const;

private:
    std::string given(const clang::SourceManager& sources, clang::FileID file, const std::string& spelled) const;
    std::string program_;
    std::map<llvm::sys::fs::UniqueID, std::string> listed_;
};

}  // namespace oroforge::cxx

#endif
