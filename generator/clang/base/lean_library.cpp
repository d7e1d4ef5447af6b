// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lean_library.hpp"

#include <vector>

namespace oroforge::cxx {

namespace {

bool isAllocator(const clang::CXXRecordDecl& type) {
    const clang::IdentifierInfo* name = type.getIdentifier();
    if (name == nullptr || type.getDescribedClassTemplate() == nullptr) return false;
    const llvm::StringRef text = name->getName();
    return (text == "allocator" || text == "__new_allocator" || text == "new_allocator") &&
           type.getASTContext().getSourceManager().isInSystemHeader(type.getLocation());
}

bool isComparison(const clang::NamedDecl* declaration) {
    if (declaration == nullptr) return false;
    const clang::OverloadedOperatorKind kind = declaration->getDeclName().getCXXOverloadedOperator();
    return kind == clang::OO_EqualEqual || kind == clang::OO_ExclaimEqual;
}

}  // namespace

void dropComparisons(clang::TagDecl& type) {
    auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(&type);
    if (record == nullptr || !isAllocator(*record)) return;
    std::vector<clang::Decl*> dropped;
    for (clang::Decl* member : record->decls()) {
        const auto* declared = llvm::dyn_cast<clang::FriendDecl>(member);
        if (declared != nullptr && isComparison(declared->getFriendDecl())) dropped.push_back(member);
    }
    for (clang::Decl* member : dropped) record->removeDecl(member);
}

}  // namespace oroforge::cxx
