// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "source_run.hpp"

#include <fstream>
#include <iterator>
#include <optional>

#include <clang/base/parse_files.hpp>

namespace oroforge::cxx {

namespace {

std::string pathOf(const SourceRun& run) { return run.root + "/" + run.file; }

std::string textOf(const SourceRun& run) {
    const auto given = run.virtualFiles.find(pathOf(run));
    if (given != run.virtualFiles.end()) return given->second;
    std::ifstream in(pathOf(run), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class MessageCollector : public clang::DiagnosticConsumer {
public:
    MessageCollector(const SourceRun& run, std::vector<CompileMessage>& messages) : run_(run), messages_(messages) {}
    void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override {
        clang::DiagnosticConsumer::HandleDiagnostic(level, info);
        if (level < clang::DiagnosticsEngine::Error) return;
        CompileMessage message;
        message.kind = kindOf(info.getID());
        if (info.hasSourceManager() && info.getLocation().isValid()) {
            const PackagePlaces places(info.getSourceManager(), run_);
            // Text after the source is generated: a missing type makes a probe fail, and that is the answer.
            if (places.isBehind(info.getLocation())) return;
            message.where = places.locate(info.getLocation());
        }
        llvm::SmallString<128> text;
        info.FormatDiagnostic(text);
        message.text = text.str().str();
        messages_.push_back(std::move(message));
    }

private:
    static CompileMessage::Kind kindOf(unsigned id) {
        if (id == clang::diag::err_pp_file_not_found) return CompileMessage::MissingFile;
        // The user's own #error says nothing about braces.
        if (id == clang::diag::err_pp_hash_error) return CompileMessage::Meaning;
        const llvm::StringRef category =
            clang::DiagnosticIDs::getCategoryNameFromID(clang::DiagnosticIDs::getCategoryNumberForDiag(id));
        return category == "Parse Issue" || category == "Lexical or Preprocessor Issue" ? CompileMessage::Syntax
                                                                                        : CompileMessage::Meaning;
    }

    const SourceRun& run_;
    std::vector<CompileMessage>& messages_;
};

}  // namespace

PackagePlaces::PackagePlaces(const clang::SourceManager& sources, const SourceRun& run)
    : sources_(sources), run_(run), sourceSize_(textOf(run).size()) {}

std::string PackagePlaces::fileOf(clang::SourceLocation at) const {
    if (at.isInvalid()) return {};
    const clang::FileID id = sources_.getFileID(sources_.getExpansionLoc(at));
    const auto entry = sources_.getFileEntryRefForID(id);
    if (!entry) return {};
    llvm::SmallString<256> path(entry->getName());
    llvm::sys::path::remove_dots(path, /*remove_dot_dot=*/true);
    const std::string name = path.str().str();
    const bool inside = name.compare(0, run_.root.size() + 1, run_.root + "/") == 0;
    return inside ? name.substr(run_.root.size() + 1) : std::string();
}

diag::Location PackagePlaces::locate(clang::SourceLocation at) const {
    const std::string file = fileOf(at);
    if (file.empty() || isBehind(at)) return {};
    const clang::PresumedLoc place = sources_.getPresumedLoc(sources_.getExpansionLoc(at), /*UseLineDirectives=*/false);
    return {run_.shown + file, place.getLine(), place.getColumn()};
}

std::size_t PackagePlaces::offset(clang::SourceLocation at) const {
    return sources_.getFileOffset(sources_.getExpansionLoc(at));
}

bool PackagePlaces::isBehind(clang::SourceLocation at) const {
    if (at.isInvalid()) return false;
    const clang::SourceLocation seen = sources_.getExpansionLoc(at);
    return sources_.getFileID(seen) == sources_.getMainFileID() && sources_.getFileOffset(seen) >= sourceSize_;
}

bool runOnSource(const SourceRun& run, SourceVisitor& visitor, std::vector<CompileMessage>& messages) {
    MessageCollector collector(run, messages);
    bool reachedEnd = false;
    std::optional<PackagePlaces> places;
    Parse parse;
    parse.mainFile = pathOf(run);
    parse.files = run.virtualFiles;
    parse.files[parse.mainFile] = textOf(run) + run.behind;
    parse.flags = run.flags;
    parse.resourceDir = run.resourceDir;
    parse.messages = &collector;
    parse.begin = [&](clang::CompilerInstance& compiler) {
        places.emplace(compiler.getSourceManager(), run);
        visitor.begin(compiler.getPreprocessor());
    };
    parse.skipsBody = [&](clang::Decl& function) { return places->fileOf(function.getLocation()).empty(); };
    parse.end = [&](clang::Sema& sema) {
        reachedEnd = true;
        visitor.visit(sema);
    };
    parseFiles(parse);
    return reachedEnd;
}

}  // namespace oroforge::cxx
