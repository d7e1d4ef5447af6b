// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "known_types.hpp"

#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

std::string toolchainName(const clang::CXXRecordDecl& record) {
    return outermostNamespace(record) == "RTT" ? record.getNameAsString() : std::string();
}

bool isPointerLike(clang::QualType type) {
    const auto* record = type.getNonReferenceType()->getAsCXXRecordDecl();
    if (record == nullptr) return false;
    const llvm::StringRef name = record->getName();
    return name == "shared_ptr" || name == "unique_ptr" || name == "intrusive_ptr" || name == "scoped_ptr" ||
           name == "__shared_ptr_access" || name == "__shared_ptr" ||
           ((isStandard(*record) || outermostNamespace(*record) == "__gnu_cxx") && name.starts_with("_") &&
            name.ends_with("iterator"));
}

bool isStdString(clang::QualType type) {
    const auto* record = type.getNonReferenceType()->getAsCXXRecordDecl();
    return record != nullptr && isStandard(*record, "basic_string");
}

bool isSequence(clang::QualType type) {
    const auto* record = type.getNonReferenceType()->getAsCXXRecordDecl();
    return record != nullptr &&
           (isStandard(*record, "vector") || isStandard(*record, "deque") || isStandard(*record, "list"));
}

bool isTextStream(clang::QualType type) {
    const auto* record = type.getNonReferenceType()->getAsCXXRecordDecl();
    return record != nullptr &&
           (isStandard(*record, "basic_ostringstream") || isStandard(*record, "basic_stringstream"));
}

const clang::FunctionDecl* definitionOf(const clang::FunctionDecl& function) {
    const clang::FunctionDecl* definition = nullptr;
    return function.hasBody(definition) && !definition->hasSkippedBody() ? definition : nullptr;
}

}  // namespace oroforge::cxx
