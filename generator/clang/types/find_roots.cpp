// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "find_roots.hpp"

#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

namespace {

bool isNamed(const clang::TagDecl& type) {
    return type.getIdentifier() != nullptr || type.getTypedefNameForAnonDecl() != nullptr;
}

bool isTemplated(const clang::TagDecl& type) {
    return type.isTemplated() || llvm::isa<clang::ClassTemplateSpecializationDecl>(type);
}

bool isPublic(const clang::Decl& declaration) {
    return declaration.getAccess() == clang::AS_public || declaration.getAccess() == clang::AS_none;
}

class RootFinder {
public:
    RootFinder(const clang::SourceManager& sources, const SourcePlaces& places, const AdapterFinder& adapters)
        : sources_(sources), places_(places), adapters_(adapters) {}

    void walk(const clang::DeclContext& scope) {
        for (const clang::Decl* declaration : scope.decls()) {
            if (llvm::isa<clang::NamespaceDecl, clang::LinkageSpecDecl>(declaration)) {
                walk(*llvm::cast<clang::DeclContext>(declaration));
            } else if (const auto* type = llvm::dyn_cast<clang::TagDecl>(declaration)) {
                visit(*type);
            } else if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(declaration)) {
                visit(*alias);
            }
        }
    }
    std::vector<Root> roots;

private:
    void visit(const clang::TypedefNameDecl& alias) {
        const clang::CXXRecordDecl* type = alias.getUnderlyingType()->getAsCXXRecordDecl();
        if (type == nullptr || alias.getDescribedTemplate() != nullptr || !isPublic(alias)) return;
        if (!places_.isListed(sources_, alias.getLocation()) || type->isDependentType()) return;
        if (!isOwnInstance(*type) && !adapters_.find(*type)) return;
        const auto name = nameOf(alias);
        if (name) roots.push_back({type, alias.getLocation(), *name});
    }
    bool isOwnInstance(const clang::CXXRecordDecl& type) const {
        const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&type);
        return instance != nullptr && places_.isListed(sources_, instance->getSpecializedTemplate()->getLocation());
    }
    void visit(const clang::TagDecl& type) {
        const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&type);
        if (instance != nullptr && instance->getSpecializationKind() == clang::TSK_ExplicitInstantiationDefinition &&
            places_.isListed(sources_, instance->getPointOfInstantiation()))
            roots.push_back({instance, instance->getPointOfInstantiation(), ""});
        if (!type.isThisDeclarationADefinition() || type.isImplicit() || isTemplated(type) || !isPublic(type)) return;
        if (!isNamed(type) || !places_.isListed(sources_, type.getLocation())) return;
        roots.push_back({&type, type.getLocation(), ""});
        if (llvm::isa<clang::CXXRecordDecl>(type)) walk(type);
    }

    const clang::SourceManager& sources_;
    const SourcePlaces& places_;
    const AdapterFinder& adapters_;
};

}  // namespace

std::vector<Root> findRoots(const clang::ASTContext& context, const SourcePlaces& places,
                            const AdapterFinder& adapters) {
    RootFinder finder(context.getSourceManager(), places, adapters);
    finder.walk(*context.getTranslationUnitDecl());
    return finder.roots;
}

}  // namespace oroforge::cxx
