// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "needed_files.hpp"

#include <algorithm>
#include <map>

namespace oroforge::cxx {

namespace {

using Files = std::vector<std::size_t>;

/// A declaration outside classes.
struct Declared {
    const clang::Decl* what;  // the canonical declaration
    std::size_t file;
    bool isWhole;  // a class is needed where it is defined
};

bool isWhole(const clang::NamedDecl& declaration) {
    if (const auto* tag = llvm::dyn_cast<clang::TagDecl>(&declaration)) return tag->isThisDeclarationADefinition();
    if (const auto* pattern = llvm::dyn_cast<clang::ClassTemplateDecl>(&declaration))
        return pattern->isThisDeclarationADefinition();
    return true;
}

class DeclarationWalk {
public:
    explicit DeclarationWalk(const IncludeWatch& read) : read_(read) {
        for (const ReadFile& file : read.files())
            for (const Word& word : file.words) wanted_.insert(word.name);
    }

    void walk(const clang::DeclContext& scope) {
        for (const clang::Decl* declaration : scope.decls()) {
            if (declaration->isImplicit() || declaration->getLocation().isInvalid()) continue;
            visit(*declaration);
            if (llvm::isa<clang::NamespaceDecl, clang::LinkageSpecDecl>(declaration))
                walk(*llvm::cast<clang::DeclContext>(declaration));
            const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(declaration);
            if (enumeration != nullptr && !enumeration->isScoped()) walk(*enumeration);
        }
    }

    std::map<const clang::IdentifierInfo*, std::vector<Declared>> declared;  // looked up only
    llvm::DenseSet<clang::SourceLocation> own;                               // places of names that the user declares
    Files directives;                                                        // files with "using namespace"

private:
    void visit(const clang::Decl& declaration) {
        const auto* named = llvm::dyn_cast<clang::NamedDecl>(&declaration);
        const bool isDirective = llvm::isa<clang::UsingDirectiveDecl>(declaration);
        const std::size_t file = fileIfWanted(declaration, named, isDirective);
        if (file == IncludeWatch::kNone) return;
        const bool isUser = read_.files()[file].isUser;
        if (isDirective && isUser) directives.push_back(file);
        if (named == nullptr || isDirective) return;
        if (const clang::IdentifierInfo* name = named->getDeclName().getAsIdentifierInfo())
            declared[name].push_back({declaration.getCanonicalDecl(), file, isWhole(*named)});
        if (isUser) noteNames(declaration);
    }

    /// Most declarations are in system headers, and no user file names them.
    std::size_t fileIfWanted(const clang::Decl& declaration, const clang::NamedDecl* named, bool isDirective) {
        const clang::IdentifierInfo* name = named != nullptr ? named->getDeclName().getAsIdentifierInfo() : nullptr;
        if (!isDirective && name != nullptr && wanted_.count(name) == 0) return IncludeWatch::kNone;
        return read_.fileOf(declaration.getLocation());
    }

    /// The name of a declaration does not refer to another one.
    void noteNames(const clang::Decl& declaration) {
        const clang::SourceManager& sources = declaration.getASTContext().getSourceManager();
        own.insert(sources.getExpansionLoc(declaration.getLocation()));
        const clang::Decl* inner = &declaration;
        if (const auto* pattern = llvm::dyn_cast<clang::TemplateDecl>(&declaration))
            inner = pattern->getTemplatedDecl();
        const auto* scope = llvm::dyn_cast_or_null<clang::DeclContext>(inner);
        if (scope == nullptr || llvm::isa<clang::NamespaceDecl>(inner)) return;
        for (const clang::Decl* member : scope->decls())
            if (!member->isImplicit() && llvm::isa<clang::NamedDecl>(member)) noteNames(*member);
    }

    const IncludeWatch& read_;
    llvm::DenseSet<const clang::IdentifierInfo*> wanted_;
};

void addOnce(std::vector<Files>& to, Files files) {
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    if (!files.empty() && std::find(to.begin(), to.end(), files) == to.end()) to.push_back(std::move(files));
}

/// Each user declaration of the name is needed; of system ones any is enough, because the system repeats names.
std::vector<Files> needsOf(const std::vector<Declared>& all, const std::vector<ReadFile>& files) {
    std::vector<Files> needs;
    Files ofSystem;
    for (std::size_t i = 0; i != all.size(); ++i) {
        const auto isSame = [&](const Declared& other) { return other.what == all[i].what; };
        if (std::find_if(all.begin(), all.end(), isSame) != all.begin() + static_cast<std::ptrdiff_t>(i)) continue;
        Files whole, any;
        bool isUser = false;
        for (const Declared& one : all) {
            if (!isSame(one)) continue;
            any.push_back(one.file);
            if (one.isWhole) whole.push_back(one.file);
            isUser |= files[one.file].isUser;
        }
        const Files& enough = whole.empty() ? any : whole;
        if (isUser)
            addOnce(needs, enough);
        else
            ofSystem.insert(ofSystem.end(), enough.begin(), enough.end());
    }
    addOnce(needs, ofSystem);
    return needs;
}

}  // namespace

std::vector<std::vector<Files>> neededFiles(const IncludeWatch& read, const clang::ASTContext& context) {
    const std::vector<ReadFile>& files = read.files();
    DeclarationWalk all(read);
    all.walk(*context.getTranslationUnitDecl());
    std::map<const clang::IdentifierInfo*, std::vector<Files>> known;  // looked up only
    std::vector<std::vector<Files>> result(files.size());
    for (std::size_t file = 0; file != files.size(); ++file) {
        std::vector<Files>& needs = result[file];
        llvm::DenseSet<const clang::IdentifierInfo*> seen;
        for (const Word& word : files[file].words) {
            const auto found = all.declared.find(word.name);
            const bool isOwn = word.at.isValid() && all.own.count(word.at) != 0;
            if (found == all.declared.end() || isOwn || !seen.insert(word.name).second) continue;
            const auto [entry, isNew] = known.try_emplace(word.name);
            if (isNew) entry->second = needsOf(found->second, files);
            for (const Files& need : entry->second)
                if (std::find(need.begin(), need.end(), file) == need.end()) addOnce(needs, need);
        }
        for (const std::size_t macro : files[file].macros) addOnce(needs, {macro});
        // "using namespace" may change the meaning of everything that is read after it.
        for (const std::size_t directive : all.directives)
            if (files[file].isUser && directive != file) addOnce(needs, {directive});
    }
    return result;
}

}  // namespace oroforge::cxx
