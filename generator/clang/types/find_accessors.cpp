// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "find_accessors.hpp"

#include <cctype>
#include <set>

namespace oroforge::cxx {

namespace {

std::string withoutMarks(std::string name) {
    if (name.size() > 2 && name.compare(0, 2, "m_") == 0) name.erase(0, 2);
    while (name.size() > 1 && name.front() == '_') name.erase(0, 1);
    while (name.size() > 1 && name.back() == '_') name.pop_back();
    return name;
}

std::set<std::string> spellings(const std::string& verb, const std::string& name) {
    std::string upper = name;
    upper[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(upper[0])));
    return {name, verb + upper, verb + "_" + name};
}

clang::QualType valueOf(clang::QualType type) { return type.getNonReferenceType().getUnqualifiedType(); }

bool isUsable(const clang::CXXMethodDecl& method) {
    return method.getAccess() == clang::AS_public && !method.isStatic() && !method.isDeleted();
}

}  // namespace

std::optional<Accessors> findAccessors(const clang::FieldDecl& field) {
    const auto* owner = llvm::dyn_cast<clang::CXXRecordDecl>(field.getParent());
    if (owner == nullptr || field.getNameAsString().empty()) return std::nullopt;
    const clang::ASTContext& context = field.getASTContext();
    const auto isOfField = [&](clang::QualType type) {
        return context.hasSameType(valueOf(type), field.getType().getUnqualifiedType());
    };
    Accessors found{withoutMarks(field.getNameAsString()), {model::AccessKind::Functions}};
    model::FieldAccess& access = found.access;
    std::set<std::string> getters = spellings("get", found.name);
    if (field.getType()->isBooleanType()) getters.merge(spellings("is", found.name));
    const std::set<std::string> setters = spellings("set", found.name);
    for (const clang::CXXMethodDecl* method : owner->methods()) {
        if (!isUsable(*method) || method->getDeclName().isIdentifier() == false) continue;
        const std::string name = method->getNameAsString();
        const clang::QualType result = method->getReturnType();
        if (method->getNumParams() == 0 && getters.count(name) != 0 && isOfField(result)) {
            if (method->isConst()) {
                access.get = name;
            } else if (result->isLValueReferenceType() && access.set.empty()) {
                access.set = name;
                access.isAssigned = true;
            }
        }
        if (method->getNumParams() != 1 || setters.count(name) == 0) continue;
        const clang::QualType taken = method->getParamDecl(0)->getType();
        // The stored value remains where it is, so the setter must not move from it.
        if (!isOfField(taken) || taken->isRValueReferenceType()) continue;
        access.set = name;
        access.isAssigned = false;
    }
    if (access.get.empty() || access.set.empty()) return std::nullopt;
    return found;
}

}  // namespace oroforge::cxx
