// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "diagnostic_bridge.hpp"

#include <fstream>

#include "header_edit.hpp"
#include "missing_header.hpp"
#include "standard_include.hpp"

namespace oroforge::cxx {

namespace {

/// Returns the place after the last non-blank character; only the file if it cannot be read.
diag::Location endOf(const diag::FileName& file) {
    std::ifstream in(file.str(), std::ios::binary);
    std::string line;
    diag::Location end{file};
    for (unsigned number = 1; std::getline(in, line); ++number) {
        const std::size_t last = line.find_last_not_of(" \t\r\f\v");
        if (last == std::string::npos) continue;
        end.line = number;
        end.column = static_cast<unsigned>(last) + 2;
    }
    return end;
}

}  // namespace

std::vector<diag::Fix> fixesOf(llvm::ArrayRef<clang::FixItHint> hints, const clang::SourceManager& sources,
                               const clang::LangOptions& language, const SourcePlaces& places) {
    std::vector<diag::Fix> fixes;
    for (const clang::FixItHint& hint : hints) {
        if (hint.isNull()) continue;
        const clang::CharSourceRange range = clang::Lexer::makeFileCharRange(hint.RemoveRange, sources, language);
        if (range.isInvalid()) return {};
        std::string text = hint.CodeToInsert;
        if (hint.InsertFromRange.isValid()) {
            text = clang::Lexer::getSourceText(hint.InsertFromRange, sources, language).str();
        }
        diag::Fix fix{places.locate(sources, range.getBegin()), places.locate(sources, range.getEnd()), text};
        if (fix.begin.line == 0 || fix.begin.file != fix.end.file) return {};
        fixes.push_back(std::move(fix));
    }
    return fixes;
}

void DiagnosticBridge::HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) {
    clang::DiagnosticConsumer::HandleDiagnostic(level, info);
    llvm::SmallString<128> text;
    info.FormatDiagnostic(text);
    diag::Location where;
    std::vector<diag::Fix> fixes;
    if (info.hasSourceManager()) {
        where = places_.locate(info.getSourceManager(), info.getLocation());
        fixes = fixesOf(info.getFixItHints(), info.getSourceManager(), language_, places_);
    }
    if (level == clang::DiagnosticsEngine::Note) {
        if (last_ == nullptr) return;
        // The end of the generated main file means nothing to the user; the note names a header.
        if (isAtEnd_ && last_->notes.empty() && where.line != 0) last_->where = endOf(where.file);
        last_->note(where, text.str().str());
        last_->notes.back().fixes = std::move(fixes);
        if (info.getID() == clang::diag::note_use_ifdef_guards) fixGuard(info);
        return;
    }
    // The user's compiler gives warnings about user headers.
    last_ = nullptr;
    if (level < clang::DiagnosticsEngine::Error || isFollowUp(info)) return;
    // The end of the generated main file is the end of the header that it includes last.
    isAtEnd_ = !where.file.empty() && where.line == 0;
    if (isAtEnd_) where = endOf(lastHeader_);
    if (where.file.empty()) where.file = places_.program();
    last_ = &sink_.error(where, "", text.str().str());
    last_->fixes = std::move(fixes);
    const unsigned what = info.getID();
    if (what == clang::diag::err_pp_file_not_found) hintAtMissing(info);
    if (const std::string include = missingInclude(info, text); !include.empty()) {
        last_->hint(include);
        // The compiler proposes a similar name, which is not meant.
        last_->fixes.clear();
    }
    if (what == clang::diag::err_header_import_not_header_unit || what == clang::diag::err_module_not_found)
        last_->hint("typegen reads headers, no modules: put the types into a header, and include that");
}

void DiagnosticBridge::hintAtMissing(const clang::Diagnostic& info) {
    const bool named = info.getNumArgs() != 0 && info.getArgKind(0) == clang::DiagnosticsEngine::ak_std_string;
    std::string hint = named ? folderHint(info.getArgStdStr(0), last_->where.file) : std::string();
    if (hint.empty()) hint = std::exchange(missingHint_, {});
    if (!hint.empty()) last_->hint(hint);
}

bool DiagnosticBridge::isFollowUp(const clang::Diagnostic& info) {
    if (!info.hasSourceManager()) return false;
    const std::string header = places_.listedAbove(info.getSourceManager(), info.getLocation());
    const bool noFile = info.getID() == clang::diag::err_pp_file_not_found;
    const bool endless = info.getID() == clang::diag::err_template_recursion_depth_exceeded;
    if (!noFile && !endless) return halted_.count(header) != 0;
    halted_.insert(header);
    // If each instance needs two more, only a truly fatal error, which the next one is, stops the compiler.
    if (endless && engine_ != nullptr) engine_->setFatalsAsError(false);
    return false;
}

void DiagnosticBridge::fixGuard(const clang::Diagnostic& info) {
    const clang::SourceManager& sources = info.getSourceManager();
    if (!last_->fixes.empty() || sources.isInSystemHeader(info.getLocation())) return;
    const clang::FileID file = sources.getFileID(sources.getExpansionLoc(info.getLocation()));
    const int offset = static_cast<int>(placeForPragmaOnce(sources.getBufferData(file).str()));
    const diag::Location at = places_.locate(sources, sources.getLocForStartOfFile(file).getLocWithOffset(offset));
    last_->fixes = {{at, at, "#pragma once\n"}};
}

}  // namespace oroforge::cxx
