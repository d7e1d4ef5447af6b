// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "check_headers.hpp"

#include "header_edit.hpp"
#include "source_places.hpp"

namespace oroforge::cxx {

void HeaderCheck::checkRead(const model::Header& header) {
    const auto entry = preprocessor_.getFileManager().getOptionalFileRef(header.path);
    if (!entry) return;
    // The compiler forgets a guard if it skipped the header because of it.
    const auto text = preprocessor_.getFileManager().getBufferForFile(*entry);
    const std::string guard = text ? guardOf((*text)->getBuffer().str()) : "";
    const clang::MacroInfo* macro =
        guard.empty() ? nullptr : preprocessor_.getMacroInfo(preprocessor_.getIdentifierInfo(guard));
    if (macro == nullptr) return;
    const clang::SourceManager& sources = preprocessor_.getSourceManager();
    const auto definer = sources.getFileEntryRefForID(sources.getFileID(macro->getDefinitionLoc()));
    // An option of the command line (-D) leaves a header out on purpose.
    if (!definer || definer->getUniqueID() == entry->getUniqueID()) return;
    sink_
        .error({plainPath(header.path)}, "TK063",
               "nothing of this header is read: its include guard '" + guard + "' is defined already")
        .note(places_.locate(sources, macro->getDefinitionLoc()), "defined here")
        .hint("give each header a guard of its own, or use #pragma once");
}

void HeaderCheck::checkGuard(const clang::TagDecl& type) {
    const clang::SourceManager& sources = preprocessor_.getSourceManager();
    const clang::FileID file = sources.getFileID(sources.getExpansionLoc(type.getLocation()));
    const auto entry = sources.getFileEntryRefForID(file);
    if (!entry || !known_.insert(file).second) return;
    if (preprocessor_.getHeaderSearchInfo().isFileMultipleIncludeGuarded(*entry)) return;
    const int offset = static_cast<int>(placeForPragmaOnce(sources.getBufferData(file).str()));
    const auto at = places_.locate(sources, sources.getLocForStartOfFile(file).getLocWithOffset(offset));
    diag::Diagnostic& warning =
        sink_.warning(at, "TK062", "this header has no include guard: including it twice would define its types twice");
    warning.hint("put #pragma once into its first line");
    warning.fixes = {{at, at, "#pragma once\n"}};
}

}  // namespace oroforge::cxx
