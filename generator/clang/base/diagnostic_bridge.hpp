// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Hands the compiler's own errors to our sink with their notes and proposals, words unchanged.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_DIAGNOSTIC_BRIDGE_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_DIAGNOSTIC_BRIDGE_HPP

#include <set>
#include <string>

#include <diag/sink.hpp>

#include "source_places.hpp"

namespace oroforge::cxx {

/// What the compiler proposes, in our terms. Nothing if a part of it lies in a macro.
std::vector<diag::Fix> fixesOf(llvm::ArrayRef<clang::FixItHint> hints, const clang::SourceManager& sources,
                               const clang::LangOptions& language, const SourcePlaces& places);

class DiagnosticBridge : public clang::DiagnosticConsumer {
public:
    /// `lastHeader` is what the main file includes last.
    DiagnosticBridge(const SourcePlaces& places, diag::Sink& sink, std::string lastHeader)
        : places_(places), sink_(sink), lastHeader_(std::move(lastHeader)) {}
    void BeginSourceFile(const clang::LangOptions& language, const clang::Preprocessor*) override {
        language_ = language;
    }
    void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override;

    /// A file that is not found must not hide what is wrong in other headers.
    void goOnAfterFatalErrors(clang::DiagnosticsEngine& engine) {
        engine_ = &engine;
        engine.setFatalsAsError(true);
    }

    /// Said once, of the first file that is not found and of which no folder is known.
    void hintAtMissingFile(std::string hint) { missingHint_ = std::move(hint); }

private:
    /// After a file that is not found the compiler itself would say no more; of the header in which it happened we do
    /// the same.
    bool isFollowUp(const clang::Diagnostic& info);
    void hintAtMissing(const clang::Diagnostic& info);
    void fixGuard(const clang::Diagnostic& info);

    const SourcePlaces& places_;
    diag::Sink& sink_;
    std::string lastHeader_;
    std::string missingHint_;
    clang::DiagnosticsEngine* engine_ = nullptr;
    clang::LangOptions language_;
    std::set<std::string> halted_;
    bool isAtEnd_ = false;              // the last error; a note may say of which header
    diag::Diagnostic* last_ = nullptr;  // notes belong to the error before them; valid until the next report
};

}  // namespace oroforge::cxx

#endif
