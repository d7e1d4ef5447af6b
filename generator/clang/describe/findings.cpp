// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "findings.hpp"

namespace oroforge::cxx {

void Findings::warn(const diag::Location& where, const char* code, const std::string& message) {
    remarks_.warning(where, code, message);
}

diag::Diagnostic& Findings::remark(clang::SourceLocation at, const char* code, const std::string& message) {
    return (isLate() ? unused_ : remarks_).warning(locate(at), code, message);
}

bool Findings::isAdded(clang::SourceLocation at, const std::string& what) {
    if (isCertain()) return true;
    warn(locate(at), "OC022", what + " is added " + (isLate() ? late_ : why()));
    return false;
}

}  // namespace oroforge::cxx
