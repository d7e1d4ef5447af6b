// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "include_watch.hpp"

#include <cctype>
#include <memory>

namespace oroforge::cxx {

class IncludeWatch::Callbacks : public clang::PPCallbacks {
public:
    explicit Callbacks(IncludeWatch& to) : to_(to) {}

    void InclusionDirective(clang::SourceLocation at, const clang::Token&, llvm::StringRef, bool,
                            clang::CharSourceRange, clang::OptionalFileEntryRef file, llvm::StringRef, llvm::StringRef,
                            const clang::Module*, bool, clang::SrcMgr::CharacteristicKind) override {
        to_.noteInclude(at, file);
    }
    void MacroExpands(const clang::Token& name, const clang::MacroDefinition& definition, clang::SourceRange,
                      const clang::MacroArgs*) override {
        to_.noteMacro(name, definition);
    }
    void Ifdef(clang::SourceLocation, const clang::Token& name, const clang::MacroDefinition& definition) override {
        to_.noteMacro(name, definition);
    }
    void Ifndef(clang::SourceLocation, const clang::Token& name, const clang::MacroDefinition& definition) override {
        to_.noteMacro(name, definition);
    }
    void Defined(const clang::Token& name, const clang::MacroDefinition& definition, clang::SourceRange) override {
        to_.noteMacro(name, definition);
    }

private:
    IncludeWatch& to_;
};

void IncludeWatch::watch(clang::Preprocessor& preprocessor) {
    preprocessor_ = &preprocessor;
    preprocessor.addPPCallbacks(std::make_unique<Callbacks>(*this));
}

std::size_t IncludeWatch::number(const clang::FileEntry& entry) {
    const auto [found, isNew] = numbers_.try_emplace(&entry, files_.size());
    if (isNew) files_.emplace_back();
    return found->second;
}

std::size_t IncludeWatch::number(clang::FileID file) {
    if (file == current_) return currentNumber_;
    const clang::SourceManager& sources = preprocessor_->getSourceManager();
    const auto entry = sources.getFileEntryRefForID(file);
    current_ = file;
    currentNumber_ = entry ? number(entry->getFileEntry()) : kNone;
    if (entry && sources.getFileCharacteristic(sources.getLocForStartOfFile(file)) == clang::SrcMgr::C_User)
        files_[currentNumber_].isUser = true;
    return currentNumber_;
}

void IncludeWatch::take(const clang::Token& token) {
    const bool names = token.is(clang::tok::identifier) && !behindDot_;
    behindDot_ = token.isOneOf(clang::tok::period, clang::tok::arrow);
    if (!names) return;
    const clang::SourceManager& sources = preprocessor_->getSourceManager();
    const clang::SourceLocation at = sources.getExpansionLoc(token.getLocation());
    const std::size_t file = number(sources.getFileID(at));
    if (file != kNone && files_[file].isUser) files_[file].words.push_back({token.getIdentifierInfo(), at});
}

void IncludeWatch::addWords(const std::string& text, clang::SourceLocation at) {
    const clang::SourceManager& sources = preprocessor_->getSourceManager();
    const std::size_t file = number(sources.getFileID(sources.getExpansionLoc(at)));
    if (file == kNone) return;
    const auto isLetter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && isLetter(text[end])) ++end;
        // It has no place, because it is not the name of a declaration.
        if (end != i) files_[file].words.push_back({preprocessor_->getIdentifierInfo(text.substr(i, end - i)), {}});
        i = end + 1;
    }
}

void IncludeWatch::noteInclude(clang::SourceLocation at, clang::OptionalFileEntryRef file) {
    const std::size_t from = fileOf(at);
    const std::size_t to = file ? number(file->getFileEntry()) : kNone;
    if (from != kNone && to != kNone) files_[from].includes.insert(to);
}

void IncludeWatch::noteMacro(const clang::Token& name, const clang::MacroDefinition& definition) {
    const clang::MacroInfo* macro = definition.getMacroInfo();
    if (macro == nullptr) return;
    const clang::SourceManager& sources = preprocessor_->getSourceManager();
    const std::size_t user = number(sources.getFileID(sources.getExpansionLoc(name.getLocation())));
    const std::size_t maker = fileOf(macro->getDefinitionLoc());
    if (user == kNone || maker == kNone || user == maker) return;
    // System headers do not depend on each other's order, but on what the user defined before.
    if (files_[user].isUser || files_[maker].isUser) files_[user].macros.insert(maker);
}

std::size_t IncludeWatch::fileOf(clang::SourceLocation at) const {
    if (at.isInvalid()) return kNone;
    const clang::SourceManager& sources = preprocessor_->getSourceManager();
    const auto entry = sources.getFileEntryRefForID(sources.getFileID(sources.getExpansionLoc(at)));
    const auto found = entry ? numbers_.find(&entry->getFileEntry()) : numbers_.end();
    return found == numbers_.end() ? kNone : found->second;
}

std::size_t IncludeWatch::fileCalled(const std::string& path) const {
    const auto entry = preprocessor_->getFileManager().getOptionalFileRef(path);
    const auto found = entry ? numbers_.find(&entry->getFileEntry()) : numbers_.end();
    return found == numbers_.end() ? kNone : found->second;
}

}  // namespace oroforge::cxx
