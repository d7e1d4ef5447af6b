// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Passes the compiler's errors on to a diag::Sink with their notes and fixes, in the compiler's words.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_DIAGNOSTIC_BRIDGE_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_DIAGNOSTIC_BRIDGE_HPP

#include <set>
#include <string>

#include <diag/sink.hpp>

#include "source_places.hpp"

namespace oroforge::cxx {

/// Converts the compiler's fixes. Returns nothing if a part of one is in a macro.
std::vector<diag::Fix> fixesOf(llvm::ArrayRef<clang::FixItHint> hints, const clang::SourceManager& sources,
                               const clang::LangOptions& language, const SourcePlaces& places);

class DiagnosticBridge : public clang::DiagnosticConsumer {
public:
    /// `lastHeader` is the header that the main file includes last.
    DiagnosticBridge(const SourcePlaces& places, diag::Sink& sink, std::string lastHeader)
        : places_(places), sink_(sink), lastHeader_(std::move(lastHeader)) {}
    void BeginSourceFile(const clang::LangOptions& language, const clang::Preprocessor*) override {
        language_ = language;
    }
    void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override;

    /// A missing file must not hide errors in other headers.
    void goOnAfterFatalErrors(clang::DiagnosticsEngine& engine) {
        engine_ = &engine;
        engine.setFatalsAsError(true);
    }

    /// The hint is given once, for the first missing file whose folder is not known.
    void hintAtMissingFile(std::string hint) { missingHint_ = std::move(hint); }

private:
    /// clang would report nothing after a missing file; the bridge is silent only for the header in which it happened.
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
    bool isAtEnd_ = false;              // true for the last error; a note may name the header
    diag::Diagnostic* last_ = nullptr;  // notes belong to the error before them; valid until the next report
};

}  // namespace oroforge::cxx

#endif
