// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "field_fixes.hpp"

#include <map>
#include <set>
#include <tuple>

#include <clang/base/diagnostic_bridge.hpp>
#include <clang/base/header_edit.hpp>

#include "rejection.hpp"

namespace oroforge::cxx {

namespace {

using Place = std::tuple<std::string, unsigned, unsigned>;

Place placeOf(const diag::Location& where) { return {where.file.str(), where.line, where.column}; }

/// Fields of all classes, by the places of their names. Fields from macros are left out, because they share places.
class FieldsByPlace {
public:
    FieldsByPlace(const clang::ASTContext& context, const SourcePlaces& places)
        : sources_(context.getSourceManager()), places_(places) {
        walk(*context.getTranslationUnitDecl());
    }
    const clang::FieldDecl* at(const diag::Location& where) const {
        const auto found = fields_.find(placeOf(where));
        return found == fields_.end() ? nullptr : found->second;
    }

private:
    void walk(const clang::DeclContext& scope) {
        for (const clang::Decl* declaration : scope.decls()) {
            if (const auto* field = llvm::dyn_cast<clang::FieldDecl>(declaration)) {
                add(*field);
            } else if (const auto* pattern = llvm::dyn_cast<clang::ClassTemplateDecl>(declaration)) {
                walk(*pattern->getTemplatedDecl());
            } else if (llvm::isa<clang::NamespaceDecl, clang::LinkageSpecDecl, clang::RecordDecl>(declaration)) {
                walk(*llvm::cast<clang::DeclContext>(declaration));
            }
        }
    }
    void add(const clang::FieldDecl& field) {
        if (field.getLocation().isMacroID() || field.getBeginLoc().isMacroID()) return;
        // Only the user's own headers can be changed.
        if (!places_.isListed(sources_, field.getLocation())) return;
        fields_[placeOf(places_.locate(sources_, field.getLocation()))] = &field;
    }

    const clang::SourceManager& sources_;
    const SourcePlaces& places_;
    std::map<Place, const clang::FieldDecl*> fields_;
};

/// The tokens of a field's declaration as written, from its first word to the ';'.
class Spelling {
public:
    Spelling(const clang::FieldDecl& field, const clang::ASTContext& context)
        : sources_(context.getSourceManager()), language_(context.getLangOpts()) {
        clang::Token token;
        int depth = 0;
        for (clang::SourceLocation at = field.getBeginLoc();
             !clang::Lexer::getRawToken(at, token, sources_, language_, true); at = token.getEndLoc()) {
            if (token.is(clang::tok::eof) || (depth == 0 && token.is(clang::tok::semi))) break;
            if (token.isOneOf(clang::tok::l_paren, clang::tok::l_brace, clang::tok::l_square, clang::tok::less))
                ++depth;
            if (token.isOneOf(clang::tok::r_paren, clang::tok::r_brace, clang::tok::r_square, clang::tok::greater))
                --depth;
            if (token.is(clang::tok::greatergreater)) depth -= 2;
            if (depth == 0 && token.is(clang::tok::comma)) severalNames_ = true;
            if (token.getLocation() == field.getLocation()) name_ = tokens_.size();
            tokens_.push_back({token, depth});
            if (tokens_.size() == kMost) break;
        }
    }

    /// True if "int a, b;" declares several fields, which share the words before the first name.
    bool severalNames() const { return severalNames_; }

    /// Returns the words before the name, separated by blanks.
    std::string before() const {
        std::string text;
        for (std::size_t i = 0; i < name_ && i < tokens_.size(); ++i) text += (i == 0 ? "" : " ") + spelled(i);
        return text;
    }

    /// Returns the place of `word` before the name and outside brackets, with the blanks after it.
    std::optional<clang::CharSourceRange> find(const std::string& word) const {
        for (std::size_t i = 0; i < name_ && i + 1 < tokens_.size(); ++i) {
            if (tokens_[i].depth != 0 || spelled(i) != word) continue;
            return clang::CharSourceRange::getCharRange(begin(i), begin(i + 1));
        }
        return std::nullopt;
    }

    /// Returns the range from the first word to the last one before the name.
    std::optional<clang::CharSourceRange> allBefore() const {
        if (name_ == 0 || name_ > tokens_.size()) return std::nullopt;
        return clang::CharSourceRange::getCharRange(begin(0), tokens_[name_ - 1].token.getEndLoc());
    }

    /// Returns the range from the end of the name or its brackets to the end of the declaration.
    clang::CharSourceRange initializer() const {
        std::size_t from = name_ + 1;
        while (from < tokens_.size() && !tokens_[from].token.isOneOf(clang::tok::equal, clang::tok::l_brace)) ++from;
        return clang::CharSourceRange::getCharRange(tokens_[from - 1].token.getEndLoc(),
                                                    tokens_.back().token.getEndLoc());
    }

private:
    static constexpr std::size_t kMost = 200;  // longer declarations get no fix
    struct Word {
        clang::Token token;
        int depth;
    };
    clang::SourceLocation begin(std::size_t i) const { return tokens_[i].token.getLocation(); }
    std::string spelled(std::size_t i) const {
        return clang::Lexer::getSpelling(tokens_[i].token, sources_, language_);
    }

    const clang::SourceManager& sources_;
    const clang::LangOptions& language_;
    std::vector<Word> tokens_;
    std::size_t name_ = 0;
    bool severalNames_ = false;
};

using Hints = std::vector<clang::FixItHint>;

Hints removeWord(const clang::FieldDecl& field, const clang::ASTContext& context, const char* word) {
    if (const auto range = Spelling(field, context).find(word)) return {clang::FixItHint::CreateRemoval(*range)};
    return {};
}

bool isNull(const clang::Expr& value, const clang::ASTContext& context) {
    return value.isNullPointerConstant(const_cast<clang::ASTContext&>(context), clang::Expr::NPC_NeverValueDependent) !=
           clang::Expr::NPCK_NotNull;
}

void addInclude(const clang::FieldDecl& field, const clang::ASTContext& context, Hints& hints) {
    const clang::SourceManager& sources = context.getSourceManager();
    const clang::FileID file = sources.getFileID(field.getLocation());
    const auto at = placeForInclude(sources.getBufferData(file).str(), "string");
    if (!at) return;
    const clang::SourceLocation start = sources.getLocForStartOfFile(file).getLocWithOffset(static_cast<int>(*at));
    hints.push_back(clang::FixItHint::CreateInsertion(start, "#include <string>\n"));
}

Hints makeString(const clang::FieldDecl& field, const clang::ASTContext& context) {
    static const std::set<std::string> known = {"const char *",       "char const *",       "const char * const",
                                                "char const * const", "std :: string_view", "string_view"};
    const Spelling spelling(field, context);
    const auto range = spelling.allBefore();
    if (!range || spelling.severalNames() || known.count(spelling.before()) == 0) return {};
    const bool touchesName = range->getEnd() == field.getLocation();  // "const char *name"
    Hints hints = {clang::FixItHint::CreateReplacement(*range, touchesName ? "std::string " : "std::string")};
    const clang::Expr* value = field.getInClassInitializer();
    if (value != nullptr && field.getType()->isPointerType()) {
        const clang::Expr* bare = value->IgnoreImpCasts();
        if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(bare); list != nullptr && list->getNumInits() == 1) {
            bare = list->getInit(0)->IgnoreImpCasts();
        }
        const bool empty =
            llvm::isa<clang::ImplicitValueInitExpr>(bare) ||
            (llvm::isa<clang::InitListExpr>(bare) && llvm::cast<clang::InitListExpr>(bare)->getNumInits() == 0);
        if (isNull(*bare, context)) {
            // A string made from a null pointer would fail when the struct is constructed.
            hints.push_back(clang::FixItHint::CreateRemoval(spelling.initializer()));
        } else if (!empty && !llvm::isa<clang::StringLiteral>(bare)) {
            return {};
        }
    }
    addInclude(field, context, hints);
    return hints;
}

Hints hintsFor(const std::string& code, const clang::FieldDecl& field, const clang::ASTContext& context) {
    const auto is = [&](Reason reason) { return code == ruleOf(reason).code; };
    clang::QualType type = field.getType();
    while (const auto* array = context.getAsArrayType(type)) type = array->getElementType();
    if (is(Reason::ConstMember) && type->isPointerType()) return makeString(field, context);
    if (is(Reason::ConstMember) && type.isConstQualified()) return removeWord(field, context, "const");
    if (is(Reason::VolatileMember) && type.isVolatileQualified()) return removeWord(field, context, "volatile");
    if (is(Reason::CString) || is(Reason::View)) return makeString(field, context);
    return {};
}

}  // namespace

void passOnWithFixes(const diag::Sink& from, const clang::ASTContext& context, const SourcePlaces& places,
                     diag::Sink& to) {
    if (from.empty()) return;
    const FieldsByPlace fields(context, places);
    const auto fixesAt = [&](const diag::Location& where, const std::string& code) {
        const clang::FieldDecl* field = fields.at(where);
        if (field == nullptr) return std::vector<diag::Fix>();
        return fixesOf(hintsFor(code, *field, context), context.getSourceManager(), context.getLangOpts(), places);
    };
    for (diag::Diagnostic diagnostic : from.all()) {
        diagnostic.fixes = fixesAt(diagnostic.where, diagnostic.code);
        // The cause may be in one of the user's templates, at the end of a chain of notes.
        for (diag::Note& note : diagnostic.notes) note.fixes = fixesAt(note.where, diagnostic.code);
        to.add(std::move(diagnostic));
    }
}

}  // namespace oroforge::cxx
