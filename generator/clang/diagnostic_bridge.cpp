// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "diagnostic_bridge.hpp"

namespace oroforge::cxx {

void DiagnosticBridge::HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) {
    clang::DiagnosticConsumer::HandleDiagnostic(level, info);
    llvm::SmallString<128> text;
    info.FormatDiagnostic(text);
    diag::Location where;
    if (info.hasSourceManager()) where = places_.locate(info.getSourceManager(), info.getLocation());
    if (level == clang::DiagnosticsEngine::Note) {
        if (last_ != nullptr) last_->note(where, text.str().str());
        return;
    }
    // Warnings about user headers are for the user's compiler to give.
    last_ = nullptr;
    if (level < clang::DiagnosticsEngine::Error) return;
    if (where.file.empty()) where.file = "typegen";
    last_ = &sink_.error(where, "", text.str().str());
}

}  // namespace oroforge::cxx
