// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Converts clang's locations to the user's: paths as given on the command line.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_SOURCE_PLACES_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_SOURCE_PLACES_HPP

#include <map>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>
#include <model/type_model.hpp>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// The main file, which includes the listed headers; it exists only in memory.
inline constexpr const char* kMainFile = "typegen_input.cpp";

/// Removes "a/../", "./" and "//" from a path, unless a link makes that another file.
std::string plainPath(const std::string& path);

class SourcePlaces {
public:
    /// `program` is the name of the main file in messages.
    explicit SourcePlaces(const std::vector<model::Header>& headers, std::string program = "typegen");
    const std::string& program() const { return program_; }

    /// For text from a macro: where it is written, in the macro or its arguments. Unknown if the macro pasted it.
    diag::Location locateWritten(const clang::SourceManager& sources, clang::SourceLocation at) const;
    /// For text from a macro: where the macro is used.
    diag::Location locate(const clang::SourceManager& sources, clang::SourceLocation at) const;

    /// True if the place, for text from a macro that of its use, is in one of the listed headers.
    bool isListed(const clang::SourceManager& sources, clang::SourceLocation at) const;

    /// Returns the listed header through which this place was included, the first in the chain; empty if there is none.
    std::string listedAbove(const clang::SourceManager& sources, clang::SourceLocation at) const;

private:
    std::string given(const clang::SourceManager& sources, clang::FileID file, const std::string& spelled) const;
    std::string program_;
    std::map<llvm::sys::fs::UniqueID, std::string> listed_;
};

}  // namespace oroforge::cxx

#endif
