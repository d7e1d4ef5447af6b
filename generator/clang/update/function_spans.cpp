// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "function_spans.hpp"

#include <set>

namespace oroforge::cxx {

namespace {

using clang::tok::TokenKind;

int depthChange(const clang::Token& token) {
    switch (token.getKind()) {
        case clang::tok::l_paren:
        case clang::tok::l_square:
        case clang::tok::l_brace:
        case clang::tok::less: return 1;
        case clang::tok::r_paren:
        case clang::tok::r_square:
        case clang::tok::r_brace:
        case clang::tok::greater: return -1;
        case clang::tok::greatergreater: return -2;
        default: return 0;
    }
}

bool isSpecifier(const std::string& word) {
    static const std::set<std::string> words = {"virtual",   "static", "inline", "explicit",
                                                "constexpr", "friend", "extern"};
    return words.count(word) != 0;
}

class SpanFinder {
public:
    SpanFinder(const clang::CXXMethodDecl& function, const clang::Decl& outer, const PackagePlaces& places,
               model::UserFunction& into)
        : function_(function), outer_(outer), places_(places), context_(function.getASTContext()), into_(into) {}

    void run() {
        const clang::FunctionTypeLoc type = function_.getFunctionTypeLoc();
        const clang::SourceLocation name = function_.getLocation();
        if (type.isNull() || anyMacro({outer_.getBeginLoc(), name, type.getLParenLoc(), type.getRParenLoc()})) {
            into_.isMacro = true;
            into_.whole = {places_.offset(outer_.getBeginLoc()), places_.offset(outer_.getEndLoc())};
            return;
        }
        into_.nameSpan = {places_.offset(name), places_.offset(behindName())};
        into_.brackets = {places_.offset(type.getLParenLoc()) + 1, places_.offset(type.getRParenLoc())};
        into_.qualifier = {into_.nameSpan.begin, into_.nameSpan.begin};
        if (function_.getQualifier() != nullptr)
            into_.qualifier.begin = places_.offset(function_.getQualifierLoc().getBeginLoc());
        findEnd(type);
        findWords();
        if (into_.kind == model::FunctionKind::Method) findReturns(type);
        for (const clang::ParmVarDecl* parameter : function_.parameters()) addParameter(*parameter);
    }

private:
    static bool anyMacro(std::initializer_list<clang::SourceLocation> places) {
        for (const clang::SourceLocation at : places)
            if (at.isInvalid() || at.isMacroID()) return true;
        return false;
    }

    clang::SourceLocation behindName() const {
        clang::SourceLocation last = function_.getNameInfo().getEndLoc();
        return behindWord(context_, last.isValid() ? last : function_.getLocation());
    }

    void findEnd(const clang::FunctionTypeLoc& type) {
        into_.whole.begin = places_.offset(outer_.getBeginLoc());
        into_.isDefinition = function_.doesThisDeclarationHaveABody();
        if (!into_.isDefinition) {
            const clang::SourceLocation end = behindSemicolon(context_, type.getRParenLoc());
            into_.whole.end = end.isValid() ? places_.offset(end) : 0;
            into_.isDefinition = function_.isExplicitlyDefaulted() || function_.isDeletedAsWritten();
            return;
        }
        const clang::Stmt* body = function_.getBody();
        if (body == nullptr || anyMacro({body->getBeginLoc(), body->getEndLoc()})) {
            into_.isMacro = true;
            return;
        }
        into_.body = {places_.offset(body->getBeginLoc()), places_.offset(body->getEndLoc()) + 1};
        into_.whole.end = into_.body.end;
    }

    void findWords() {
        Words words(context_, outer_.getBeginLoc());
        clang::Token token;
        while (words.next(token) && places_.offset(token.getLocation()) < into_.whole.end) {
            const std::size_t at = places_.offset(token.getLocation());
            if (!into_.body.empty() && at >= into_.body.begin) break;
            const std::string word = words.spelled(token);
            if (at < into_.nameSpan.begin && word == "virtual") into_.saysVirtual = true;
            if (at >= into_.brackets.end && (word == "override" || word == "final")) into_.saysOverride = true;
        }
    }

    void findReturns(const clang::FunctionTypeLoc& type) {
        const auto* prototype = function_.getType()->getAs<clang::FunctionProtoType>();
        if (prototype != nullptr && prototype->hasTrailingReturn()) return findTrailing(type);
        // With attributes before the type, or specifiers after it, its span is not known.
        Words words(context_, function_.getBeginLoc());
        clang::Token token;
        model::Span found;
        while (words.next(token)) {
            const std::size_t at = places_.offset(token.getLocation());
            if (at >= into_.qualifier.begin) break;
            const bool specifier = isSpecifier(words.spelled(token));
            if (specifier && found.empty()) continue;
            if (specifier || token.is(clang::tok::l_square)) return;
            if (found.empty()) found.begin = at;
            found.end = at + token.getLength();
        }
        into_.returns = found;
    }

    void findTrailing(const clang::FunctionTypeLoc& type) {
        Words words(context_, type.getRParenLoc());
        clang::Token token;
        model::Span found;
        bool behindArrow = false;
        int depth = 0;
        while (words.next(token)) {
            const std::string word = words.spelled(token);
            if (!behindArrow) {
                behindArrow = token.is(clang::tok::arrow);
                continue;
            }
            if (depth == 0 && (token.isOneOf(clang::tok::semi, clang::tok::l_brace, clang::tok::equal) ||
                               word == "override" || word == "final"))
                break;
            depth += depthChange(token);
            const std::size_t at = places_.offset(token.getLocation());
            if (found.empty()) found.begin = at;
            found.end = at + token.getLength();
        }
        into_.returns = found;
    }

    void addParameter(const clang::ParmVarDecl& parameter) {
        model::UserParameter one;
        one.name = parameter.getNameAsString();
        const clang::SourceLocation begin = parameter.getOuterLocStart();
        one.isMacro = anyMacro({begin}) || (!one.name.empty() && anyMacro({parameter.getLocation()}));
        one.whole.begin = one.whole.end = places_.offset(begin);
        Words words(context_, begin);
        clang::Token token;
        clang::Token last;
        last.startToken();
        std::size_t beforeLast = one.whole.begin;
        int depth = 0;
        while (words.next(token) && places_.offset(token.getLocation()) < into_.brackets.end) {
            if (depth == 0 && token.isOneOf(clang::tok::comma, clang::tok::equal)) break;
            depth += depthChange(token);
            beforeLast = one.whole.end;
            one.whole.end = places_.offset(token.getLocation()) + token.getLength();
            last = token;
        }
        const bool endsInName = !one.name.empty() && last.getLocation() == parameter.getLocation();
        if (one.name.empty()) one.type = one.whole;
        if (endsInName) one.type = {one.whole.begin, beforeLast};
        if (one.isMacro) one.type = {};
        // A definition inherits the default value of its declaration, but not its text.
        const clang::SourceRange value =
            parameter.hasInheritedDefaultArg() ? clang::SourceRange() : parameter.getDefaultArgRange();
        if (value.isValid()) {
            if (value.getEnd().isMacroID()) one.isMacro = true;
            one.whole.end = std::max(one.whole.end, places_.offset(behindWord(context_, value.getEnd())));
        }
        into_.parameters.push_back(std::move(one));
    }

    const clang::CXXMethodDecl& function_;
    const clang::Decl& outer_;
    const PackagePlaces& places_;
    const clang::ASTContext& context_;
    model::UserFunction& into_;
};

std::string canonicalName(clang::QualType type, const clang::ASTContext& context) {
    return type.getCanonicalType().getUnqualifiedType().getAsString(context.getPrintingPolicy());
}

}  // namespace

bool Words::next(clang::Token& token) {
    const clang::SourceManager& sources = context_.getSourceManager();
    do {
        if (at_.isInvalid() || clang::Lexer::getRawToken(at_, token, sources, context_.getLangOpts(), true))
            return false;
        if (token.is(clang::tok::eof)) return false;
        at_ = token.getEndLoc();
    } while (token.is(clang::tok::comment));
    return true;
}

std::string Words::spelled(const clang::Token& token) const {
    return clang::Lexer::getSpelling(token, context_.getSourceManager(), context_.getLangOpts());
}

clang::SourceLocation behindSemicolon(const clang::ASTContext& context, clang::SourceLocation from) {
    Words words(context, from);
    clang::Token token;
    while (words.next(token))
        if (token.is(clang::tok::semi)) return token.getEndLoc();
    return {};
}

clang::SourceLocation behindWord(const clang::ASTContext& context, clang::SourceLocation at) {
    return clang::Lexer::getLocForEndOfToken(context.getSourceManager().getExpansionLoc(at), 0,
                                             context.getSourceManager(), context.getLangOpts());
}

model::Span scopeAround(const clang::Decl& declaration, const PackagePlaces& places) {
    const clang::ASTContext& context = declaration.getASTContext();
    const clang::SourceManager& sources = context.getSourceManager();
    const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(declaration.getLexicalDeclContext());
    if (space == nullptr || space->getBeginLoc().isMacroID() || space->getRBraceLoc().isInvalid() ||
        space->getRBraceLoc().isMacroID())
        return {0, sources.getFileIDSize(sources.getFileID(sources.getExpansionLoc(declaration.getLocation())))};
    Words words(context, space->getBeginLoc());
    clang::Token token;
    while (words.next(token))
        if (token.is(clang::tok::l_brace)) break;
    return {places.offset(token.getEndLoc()), places.offset(space->getRBraceLoc())};
}

void fillSpans(const clang::CXXMethodDecl& function, const clang::Decl& outer, const PackagePlaces& places,
               model::UserFunction& into) {
    SpanFinder(function, outer, places, into).run();
}

model::CanonicalSignature canonicalSignature(const clang::FunctionDecl& function) {
    // An 'override' without a base function does not make types unknown, but clang puts int where a type is unknown.
    const bool isInt = function.getReturnType()->isSpecificBuiltinType(clang::BuiltinType::Int);
    const bool onlyOverride = function.hasAttr<clang::OverrideAttr>() && !isInt;
    if ((function.isInvalidDecl() && !onlyOverride) || function.isVariadic()) return {};
    const clang::ASTContext& context = function.getASTContext();
    model::CanonicalSignature signature;
    signature.returns = canonicalName(function.getReturnType(), context);
    for (const clang::ParmVarDecl* parameter : function.parameters()) {
        if (parameter->isInvalidDecl()) return {};
        signature.arguments.push_back(canonicalName(parameter->getType(), context));
    }
    return signature;
}

}  // namespace oroforge::cxx
