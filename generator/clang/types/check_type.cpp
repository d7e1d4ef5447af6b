// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/type_names.hpp>

#include "describe_type.hpp"

namespace oroforge::cxx {

namespace {

Rejection aboutType(Reason reason, const clang::TagDecl& type, clang::SourceLocation at) {
    Rejection rejection;
    rejection.reason = reason;
    rejection.subject = "type '" + shownName(type) + "'";
    rejection.type = shownName(type);
    rejection.at = at;
    return rejection;
}

/// Returns the place of the first virtual function written in the class, else the place of the class.
clang::SourceLocation virtualPlace(const clang::CXXRecordDecl& type) {
    for (const clang::CXXMethodDecl* method : type.methods()) {
        if (method->isVirtual() && !method->isImplicit()) return method->getLocation();
    }
    return type.getLocation();
}

bool isOpen(const clang::FunctionDecl* function) {
    return function != nullptr && !function->isDeleted() && function->getAccess() != clang::AS_private &&
           function->getAccess() != clang::AS_protected;
}

clang::SourceLocation placeOf(const clang::FunctionDecl* function, const clang::CXXRecordDecl& type) {
    const bool written = function != nullptr && !function->isImplicit();
    return written ? function->getLocation() : type.getLocation();
}

/// True for names such as `struct stat` and `stat()`: the name alone then means the function, also in generated code.
bool sharesName(const clang::TagDecl& type) {
    if (type.getIdentifier() == nullptr) return false;
    // From <sys/time.h>. The variable is in <time.h>, which the headers may lack, but generated code includes.
    if (type.getName() == "timezone" && type.getDeclContext()->getRedeclContext()->isTranslationUnit()) return true;
    for (const clang::NamedDecl* other : type.getDeclContext()->getRedeclContext()->lookup(type.getDeclName()))
        if (llvm::isa<clang::ValueDecl, clang::FunctionTemplateDecl>(other->getUnderlyingDecl())) return true;
    return false;
}

}  // namespace

bool isHidden(const clang::TagDecl& type) {
    for (const clang::Decl* scope = &type; llvm::isa<clang::TagDecl>(scope);
         scope = llvm::cast<clang::Decl>(scope->getDeclContext())) {
        if (scope->getAccess() == clang::AS_private || scope->getAccess() == clang::AS_protected) return true;
    }
    return false;
}

void complete(const clang::TagDecl& type, clang::Sema& sema, clang::SourceLocation at) {
    sema.isCompleteType(at, sema.getASTContext().getTypeDeclType(&type));
    const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(&type);
    if (enumeration == nullptr || enumeration->getDefinition() != nullptr) return;
    const clang::EnumDecl* pattern = enumeration->getInstantiatedFromMemberEnum();
    // Without a definition in the template, completing the enum would be an error.
    if (pattern != nullptr && pattern->getDefinition() != nullptr)
        sema.RequireCompleteEnumDecl(const_cast<clang::EnumDecl*>(enumeration), at);
}

std::vector<Rejection> checkType(const clang::TagDecl& type) {
    std::vector<Rejection> found;
    if (type.isInAnonymousNamespace()) {
        found.push_back(aboutType(Reason::InternalLinkage, type, type.getLocation()));
    } else if (type.isUnion()) {
        found.push_back(aboutType(Reason::Union, type, type.getLocation()));
    }
    const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(&type);
    if (found.empty() && record != nullptr && record->isPolymorphic()) {
        found.push_back(aboutType(Reason::Polymorphic, type, virtualPlace(*record)));
    }
    if (found.empty() && sharesName(type)) found.push_back(aboutType(Reason::SharedName, type, type.getLocation()));
    if (found.empty() && !nameOf(type)) {
        const std::string argument = unnamedArgument(type);
        const Reason reason = argument.empty() ? Reason::Unnamed : Reason::TemplateArgument;
        found.push_back(aboutType(reason, type, type.getLocation()));
        if (!argument.empty()) found.back().detail = ": its argument '" + argument + "' has no name";
    }
    return found;
}

bool isCopyable(const clang::CXXRecordDecl& type, clang::Sema& sema) {
    auto* record = const_cast<clang::CXXRecordDecl*>(&type);
    return isOpen(sema.LookupCopyingConstructor(record, clang::Qualifiers::Const)) &&
           isOpen(sema.LookupCopyingAssignment(record, clang::Qualifiers::Const, false, 0));
}

std::vector<Rejection> checkSpecialMembers(const clang::CXXRecordDecl& type, clang::Sema& sema, Nature& nature) {
    // Looking a member up may declare it implicitly, so clang takes a class that is not const.
    auto* record = const_cast<clang::CXXRecordDecl*>(&type);
    std::vector<Rejection> found;
    const clang::FunctionDecl* construct = sema.LookupDefaultConstructor(record);
    if (!isOpen(construct) && !nature.isMade) {
        found.push_back(aboutType(Reason::NoDefaultConstructor, type, placeOf(construct, type)));
    }
    const clang::FunctionDecl* assign = sema.LookupCopyingAssignment(record, clang::Qualifiers::Const, false, 0);
    nature.assignable = isOpen(assign);
    // The compiler deleted it because of a constant member.
    if (nature.mayBeConstant && !type.hasUserDeclaredCopyAssignment() && !type.hasUserDeclaredMoveOperation())
        assign = nullptr;
    else
        nature.mayBeConstant = false;
    const clang::FunctionDecl* needed[] = {sema.LookupCopyingConstructor(record, clang::Qualifiers::Const), assign,
                                           sema.LookupDestructor(record)};
    for (const clang::FunctionDecl* function : needed) {
        if (isOpen(function) || (function == nullptr && nature.mayBeConstant)) continue;
        found.push_back(aboutType(Reason::NotCopyable, type, placeOf(function, type)));
        break;
    }
    return found;
}

}  // namespace oroforge::cxx
