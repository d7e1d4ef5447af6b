// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "source_places.hpp"

namespace oroforge::cxx {

std::string plainPath(const std::string& path) {
    llvm::SmallString<256> plain(path), kept(path);
    llvm::sys::path::remove_dots(kept);
    llvm::sys::path::remove_dots(plain, /*remove_dot_dot=*/true);
    if (plain.empty()) return path;
    llvm::sys::fs::UniqueID id, other;
    const bool isSame = plain == kept || (!llvm::sys::fs::getUniqueID(path, id) &&
                                          !llvm::sys::fs::getUniqueID(plain, other) && id == other);
    return (isSame ? plain : kept).str().str();
}

SourcePlaces::SourcePlaces(const std::vector<model::Header>& headers, std::string program)
    : program_(std::move(program)) {
    for (const model::Header& header : headers) {
        llvm::sys::fs::UniqueID id;
        if (!llvm::sys::fs::getUniqueID(header.path, id)) listed_.emplace(id, plainPath(header.path));
    }
}

std::string SourcePlaces::given(const clang::SourceManager& sources, clang::FileID file,
                                const std::string& spelled) const {
    if (const auto entry = sources.getFileEntryRefForID(file)) {
        const auto found = listed_.find(entry->getUniqueID());
        if (found != listed_.end()) return found->second;
    }
    // clang puts "./" before files beside the main file, and "dir/" before "../y.hpp" that dir/x.hpp includes.
    return plainPath(spelled);
}

diag::Location SourcePlaces::locate(const clang::SourceManager& sources, clang::SourceLocation at) const {
    if (at.isInvalid()) return {};
    const clang::SourceLocation seen = sources.getExpansionLoc(at);
    const clang::PresumedLoc place = sources.getPresumedLoc(seen, /*UseLineDirectives=*/false);
    if (place.isInvalid()) return {};
    const std::string file = given(sources, sources.getFileID(seen), place.getFilename());
    if (file == kMainFile) return {program_};
    return {file, place.getLine(), place.getColumn()};
}

diag::Location SourcePlaces::locateWritten(const clang::SourceManager& sources, clang::SourceLocation at) const {
    if (!at.isMacroID()) return locate(sources, at);
    const clang::SourceLocation written = sources.getSpellingLoc(at);
    return sources.isWrittenInScratchSpace(written) ? diag::Location() : locate(sources, written);
}

bool SourcePlaces::isListed(const clang::SourceManager& sources, clang::SourceLocation at) const {
    if (at.isInvalid()) return false;
    const auto entry = sources.getFileEntryRefForID(sources.getFileID(sources.getExpansionLoc(at)));
    return entry && listed_.count(entry->getUniqueID()) != 0;
}

std::string SourcePlaces::listedAbove(const clang::SourceManager& sources, clang::SourceLocation at) const {
    std::string above;
    while (at.isValid()) {
        const clang::FileID file = sources.getFileID(sources.getExpansionLoc(at));
        if (isListed(sources, at)) above = given(sources, file, "");
        at = sources.getIncludeLoc(file);
    }
    return above;
}

}  // namespace oroforge::cxx
