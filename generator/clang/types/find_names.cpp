// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "find_names.hpp"

#include <set>

#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

namespace {

class OtherNameFinder {
public:
    OtherNameFinder(const clang::SourceManager& sources, const SourcePlaces& places, const std::vector<Root>& roots)
        : sources_(sources), places_(places) {
        for (const Root& root : roots) {
            types_.insert(root.type);
            if (!root.alias.empty()) known_.insert(root.alias);
        }
    }

    void walk(const clang::DeclContext& scope) {
        for (const clang::Decl* declaration : scope.decls()) {
            const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(declaration);
            const bool isOwn = record != nullptr && types_.count(record) != 0 &&
                               !llvm::isa<clang::ClassTemplateSpecializationDecl>(record);
            if (isOwn || llvm::isa<clang::NamespaceDecl, clang::LinkageSpecDecl>(declaration))
                walk(*llvm::cast<clang::DeclContext>(declaration));
            else if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(declaration))
                visit(*alias);
        }
    }
    std::vector<OtherName> names;

private:
    void visit(const clang::TypedefNameDecl& alias) {
        const clang::QualType named = alias.getUnderlyingType();
        const clang::TagDecl* type = named->getAsTagDecl();
        if (type == nullptr || type->getDefinition() == nullptr || named.getCanonicalType().hasQualifiers()) return;
        if (types_.count(type->getDefinition()) == 0 || !places_.isListed(sources_, alias.getLocation())) return;
        if (alias.getAccess() != clang::AS_public && alias.getAccess() != clang::AS_none) return;
        const auto name = nameOf(alias);
        const auto first = nameOf(*type->getDefinition());
        if (!name || !first || first->registry == *name || !known_.insert(*name).second) return;
        names.push_back({type->getDefinition(), alias.getLocation(), *name});
    }

    const clang::SourceManager& sources_;
    const SourcePlaces& places_;
    std::set<const clang::TagDecl*> types_;
    std::set<std::string> known_;
};

}  // namespace

std::vector<OtherName> findNames(const clang::ASTContext& context, const SourcePlaces& places,
                                 const std::vector<Root>& roots) {
    OtherNameFinder finder(context.getSourceManager(), places, roots);
    finder.walk(*context.getTranslationUnitDecl());
    return finder.names;
}

}  // namespace oroforge::cxx
