// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Hands the compiler's own errors to our sink, words unchanged.
#ifndef OROFORGE_GENERATOR_CLANG_DIAGNOSTIC_BRIDGE_HPP
#define OROFORGE_GENERATOR_CLANG_DIAGNOSTIC_BRIDGE_HPP

#include <diag/sink.hpp>

#include "source_places.hpp"

namespace oroforge::cxx {

class DiagnosticBridge : public clang::DiagnosticConsumer {
public:
    DiagnosticBridge(const SourcePlaces& places, diag::Sink& sink) : places_(places), sink_(sink) {}
    void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override;

private:
    const SourcePlaces& places_;
    diag::Sink& sink_;
    diag::Diagnostic* last_ = nullptr;  // notes belong to the error before them; valid until the next report
};

}  // namespace oroforge::cxx

#endif
