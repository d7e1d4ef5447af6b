// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "nesting_limit.hpp"

#include <algorithm>

namespace oroforge::cxx {

namespace {

// A level of template arguments takes about 6 KB of stack, an operator 2 KB; parseFiles() has a multiple of that.
constexpr unsigned kMostAngles = 4000;
constexpr unsigned kMostWords = 20000;

}  // namespace

const char* NestingLimit::tooMuch(const clang::Token& token) {
    const bool followsName = std::exchange(wasName_, token.isAnyIdentifier());
    ++words_;
    switch (token.getKind()) {
        case clang::tok::semi:
        case clang::tok::l_brace:
        case clang::tok::r_brace: angles_ = words_ = 0; break;
        case clang::tok::comma: words_ = 0; break;
        case clang::tok::less: angles_ += followsName ? 1 : 0; break;
        case clang::tok::greater: angles_ -= std::min(angles_, 1U); break;
        case clang::tok::greatergreater: angles_ -= std::min(angles_, 2U); break;
        default:
            // Long strings consist of many literals.
            if (clang::tok::isStringLiteral(token.getKind())) --words_;
    }
    if (angles_ > kMostAngles) return "template arguments are nested more than 4000 deep";
    return words_ > kMostWords ? "more than 20000 words before the next ',', ';' or brace" : nullptr;
}

void NestingLimit::take(const clang::Token& token, clang::DiagnosticsEngine& engine) {
    const char* message = ended_ ? nullptr : tooMuch(token);
    if (message != nullptr) {
        ended_ = true;
        engine.setFatalsAsError(false);  // no errors follow from the early end
        engine.Report(token.getLocation(),
                      engine.getDiagnosticIDs()->getCustomDiagID(clang::DiagnosticIDs::Fatal, message));
    }
    if (!ended_) return;
    // clang's own parser does the same where it gives up: there is no other way to stop it.
    auto& end = const_cast<clang::Token&>(token);
    end.setKind(clang::tok::eof);
    end.setEofData(nullptr);
}

}  // namespace oroforge::cxx
