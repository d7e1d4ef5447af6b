// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "adapter_match.hpp"

#include <set>

#include <clang/base/type_names.hpp>
#include <diag/nearest_match.hpp>

namespace oroforge::cxx {

namespace {

const clang::NamedDecl* lookUp(const clang::DeclContext& scope, const std::string& name, clang::ASTContext& context) {
    for (const clang::NamedDecl* found : scope.lookup(&context.Idents.get(name))) {
        const clang::NamedDecl* meant = found->getUnderlyingDecl();
        if (llvm::isa<clang::TagDecl, clang::ClassTemplateDecl, clang::TypedefNameDecl, clang::NamespaceDecl,
                      clang::NamespaceAliasDecl>(meant))
            return meant;
    }
    return nullptr;
}

const clang::DeclContext* scopeOf(const clang::NamedDecl* declaration) {
    if (const auto* alias = llvm::dyn_cast<clang::NamespaceAliasDecl>(declaration)) return alias->getNamespace();
    if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(declaration)) return space;
    if (const auto* outer = llvm::dyn_cast<clang::CXXRecordDecl>(declaration)) return outer->getDefinition();
    return nullptr;
}

std::vector<std::string> classesIn(const clang::DeclContext& scope) {
    std::vector<std::string> names;
    for (const clang::Decl* declaration : scope.decls()) {
        if (llvm::isa<clang::TagDecl, clang::ClassTemplateDecl, clang::TypedefNameDecl, clang::NamespaceDecl>(
                declaration))
            names.push_back(llvm::cast<clang::NamedDecl>(declaration)->getNameAsString());
    }
    return names;
}

/// Finds the class or class template of that name. Otherwise returns null and, unless the adapter is shipped, adds a
/// warning: to `misspelt` if there is a similar name, else to `absent`.
const clang::NamedDecl* declarationOf(const adapters::Adapter& adapter, clang::ASTContext& context,
                                      diag::Sink& misspelt, diag::Sink& absent) {
    const clang::DeclContext* scope = context.getTranslationUnitDecl();
    std::string rest = adapter.className;
    while (scope != nullptr) {
        const std::size_t end = rest.find("::");
        const std::string part = rest.substr(0, end);
        const clang::NamedDecl* found = lookUp(*scope, part, context);
        if (found != nullptr && end == std::string::npos && !llvm::isa<clang::NamespaceDecl>(found)) return found;
        const clang::DeclContext* next = found != nullptr && end != std::string::npos ? scopeOf(found) : nullptr;
        if (next == nullptr && !adapter.isShipped) {
            const std::string nearest = diag::didYouMean(part, classesIn(*scope));
            (nearest.empty() ? absent : misspelt)
                .warning(adapter.classWhere, "TK074", "no class '" + adapter.className + "' in the headers" + nearest)
                .hint("the adapter is not used; include the header that defines the class");
        }
        scope = next;
        if (end != std::string::npos) rest = rest.substr(end + 2);
    }
    return nullptr;
}

const clang::Decl* canonical(const clang::NamedDecl& found) {
    if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(&found)) {
        const clang::CXXRecordDecl* record = alias->getUnderlyingType()->getAsCXXRecordDecl();
        return record != nullptr ? record->getCanonicalDecl() : nullptr;
    }
    return found.getCanonicalDecl();
}

/// True if an adapter with these arguments can fit an instance; else reports an error.
bool canFit(const adapters::Adapter& adapter, const clang::Decl* declaration, diag::Sink& sink) {
    const auto* pattern = llvm::dyn_cast_or_null<clang::ClassTemplateDecl>(declaration);
    const auto fail = [&](const std::string& message) {
        if (!adapter.isShipped) sink.error(adapter.classWhere, "TK074", message);
        return false;
    };
    if (pattern == nullptr && (declaration == nullptr || !llvm::isa<clang::CXXRecordDecl>(declaration)))
        return fail("'" + adapter.className + "' is no class");
    if (adapter.arguments.empty()) return true;
    if (pattern == nullptr) return fail("'" + adapter.className + "' is no class template, so it has no 'arguments'");
    const clang::TemplateParameterList& parameters = *pattern->getTemplateParameters();
    const bool isOpen = adapter.arguments.back() == "...";
    const std::size_t named = adapter.arguments.size() - (isOpen ? 1 : 0);
    if (parameters.hasParameterPack() || named == parameters.size() || (isOpen && named < parameters.size()))
        return true;
    return fail("'" + adapter.className + "' has " + std::to_string(parameters.size()) + " template arguments, but " +
                std::to_string(named) + " are given" +
                (named < parameters.size() ? "; '...' means all that follow" : ""));
}

std::string withoutBlanks(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (c != ' ') result += c;
    return result.compare(0, 2, "::") == 0 ? result.substr(2) : result;
}

bool fits(const adapters::Pattern& wanted, const TypeName& argument, AdapterMatch& match) {
    if (wanted[0] != '$') return withoutBlanks(argument.cpp) == withoutBlanks(wanted);
    const std::string variable = wanted.substr(1);
    const std::string& name = argument.registry;
    match.names.emplace(variable, name[0] == '/' ? name.substr(1) : name);
    return match.cpp.emplace(variable, argument.cpp).first->second == argument.cpp;
}

bool fits(const std::vector<adapters::Pattern>& wanted, const std::vector<TypeName>& arguments, AdapterMatch& match) {
    for (std::size_t i = 0; i != wanted.size(); ++i) {
        if (wanted[i] == "...") return true;
        if (i == arguments.size() || !fits(wanted[i], arguments[i], match)) return false;
    }
    return wanted.empty() || wanted.size() == arguments.size();
}

}  // namespace

std::optional<clang::QualType> typeCalled(const std::string& name, clang::ASTContext& context, std::string& nearest) {
    const std::map<std::string, clang::QualType> simple = {{"bool", context.BoolTy},
                                                           {"char", context.CharTy},
                                                           {"int", context.IntTy},
                                                           {"unsigned", context.UnsignedIntTy},
                                                           {"unsigned int", context.UnsignedIntTy},
                                                           {"float", context.FloatTy},
                                                           {"double", context.DoubleTy}};
    const auto known = simple.find(name);
    if (known != simple.end()) return known->second;
    const clang::DeclContext* scope = context.getTranslationUnitDecl();
    std::string rest = name.compare(0, 2, "::") == 0 ? name.substr(2) : name;
    while (scope != nullptr) {
        const std::size_t end = rest.find("::");
        const std::string part = rest.substr(0, end);
        const clang::NamedDecl* found = lookUp(*scope, part, context);
        const auto* type = llvm::dyn_cast_or_null<clang::TypeDecl>(found);
        if (type != nullptr && end == std::string::npos) return context.getTypeDeclType(type);
        if (found == nullptr) nearest = diag::didYouMean(part, classesIn(*scope));
        scope = found != nullptr && end != std::string::npos ? scopeOf(found) : nullptr;
        if (end != std::string::npos) rest = rest.substr(end + 2);
    }
    return std::nullopt;
}

AdapterFinder::AdapterFinder(const std::vector<adapters::Adapter>& all, const clang::ASTContext& context,
                             diag::Sink& sink) {
    // The lookup may add names to the compiler's table.
    auto& table = const_cast<clang::ASTContext&>(context);
    diag::Sink absent;
    std::set<std::string> used;
    for (const adapters::Adapter& adapter : all) {
        const clang::NamedDecl* found = declarationOf(adapter, table, sink, absent);
        if (found == nullptr) continue;
        used.insert(adapter.classWhere.file);
        const clang::Decl* declaration = canonical(*found);
        if (canFit(adapter, declaration, sink)) entries_.push_back({&adapter, declaration});
    }
    // Packages share adapter files, and each has only some of their classes: warn only about files without any.
    for (const diag::Diagnostic& one : absent.all())
        if (used.count(one.where.file) == 0) sink.add(one);
}

std::optional<AdapterMatch> AdapterFinder::find(const clang::CXXRecordDecl& type) const {
    const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&type);
    const clang::Decl* pattern = instance != nullptr ? instance->getSpecializedTemplate()->getCanonicalDecl() : nullptr;
    std::optional<std::vector<TypeName>> arguments;
    for (const Entry& entry : entries_) {
        AdapterMatch match{entry.adapter, {}, {}};
        if (entry.declaration == type.getCanonicalDecl()) return match;
        if (pattern == nullptr || entry.declaration != pattern) continue;
        if (!arguments) arguments = argumentsOf(*instance);
        if (arguments && fits(entry.adapter->arguments, *arguments, match)) return match;
    }
    return std::nullopt;
}

}  // namespace oroforge::cxx
