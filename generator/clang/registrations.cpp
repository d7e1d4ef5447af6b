// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "registrations.hpp"

#include <set>

#include "function_spans.hpp"

namespace oroforge::cxx {

namespace {

bool isVerb(const std::string& name) {
    static const std::set<std::string> verbs = {"addPort",      "addLocalPort", "addEventPort", "addProperty",
                                                "addAttribute", "addConstant",  "addOperation"};
    return verbs.count(name) != 0;
}

struct Verb {
    std::string name;
    clang::SourceLocation where;
};

Verb verbOf(const clang::CallExpr& call) {
    const clang::Expr* callee = call.getCallee()->IgnoreParenImpCasts();
    Verb verb;
    if (const auto* known = llvm::dyn_cast<clang::MemberExpr>(callee)) {
        verb = {known->getMemberDecl()->getNameAsString(), known->getMemberLoc()};
    } else if (const auto* open = llvm::dyn_cast<clang::UnresolvedMemberExpr>(callee)) {
        verb = {open->getMemberName().getAsString(), open->getMemberLoc()};
    }
    return isVerb(verb.name) ? verb : Verb();
}

const clang::CallExpr* findCall(const clang::Stmt* statement) {
    if (statement == nullptr || llvm::isa<clang::LambdaExpr>(statement)) return nullptr;
    const auto* call = llvm::dyn_cast<clang::CallExpr>(statement);
    if (call != nullptr && !verbOf(*call).name.empty()) return call;
    for (const clang::Stmt* child : statement->children())
        if (const clang::CallExpr* found = findCall(child)) return found;
    return nullptr;
}

std::string memberIn(const clang::Stmt* value) {
    if (value == nullptr) return {};
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(value))
        if (llvm::isa<clang::FieldDecl>(member->getMemberDecl())) return member->getMemberDecl()->getNameAsString();
    for (const clang::Stmt* child : value->children()) {
        const std::string found = memberIn(child);
        if (!found.empty()) return found;
    }
    return {};
}

class Collector {
public:
    Collector(const clang::ASTContext& context, const PackagePlaces& places) : context_(context), places_(places) {}

    void walk(const clang::Stmt* statement, int depth) {
        if (statement == nullptr || llvm::isa<clang::LambdaExpr>(statement)) return;
        if (const auto* expression = llvm::dyn_cast<clang::Expr>(statement)) return add(*expression, depth > 1);
        const bool plain = llvm::isa<clang::CompoundStmt>(statement) || llvm::isa<clang::CXXTryStmt>(statement);
        for (const clang::Stmt* child : statement->children()) walk(child, depth + (plain && depth == 0 ? 1 : 2));
    }

    std::vector<model::UserRegistration> found;

private:
    void add(const clang::Expr& expression, bool nested) {
        const clang::CallExpr* call = findCall(&expression);
        if (call == nullptr || expression.getBeginLoc().isMacroID() || expression.getEndLoc().isMacroID()) return;
        const Verb verb = verbOf(*call);
        if (verb.where.isInvalid() || verb.where.isMacroID()) return;
        const clang::SourceLocation end = behindSemicolon(context_, expression.getEndLoc());
        if (end.isInvalid()) return;
        model::UserRegistration one;
        one.verb = verb.name;
        one.file = places_.fileOf(verb.where);
        one.where = places_.locate(verb.where);
        one.statement = {places_.offset(expression.getBeginLoc()), places_.offset(end)};
        one.receiver = {one.statement.begin, places_.offset(verb.where)};
        one.isNested = nested;
        if (call->getNumArgs() > 0) one.literal = firstString(call->getArg(0));
        for (const clang::Expr* argument : call->arguments())
            if (one.member.empty()) one.member = memberIn(argument);
        if (!one.file.empty()) found.push_back(std::move(one));
    }

    const clang::ASTContext& context_;
    const PackagePlaces& places_;
};

}  // namespace

std::string firstString(const clang::Stmt* value) {
    if (value == nullptr) return {};
    if (const auto* text = llvm::dyn_cast<clang::StringLiteral>(value))
        return text->isOrdinary() ? text->getString().str() : "";
    for (const clang::Stmt* child : value->children()) {
        const std::string found = firstString(child);
        if (!found.empty()) return found;
    }
    return {};
}

std::vector<model::UserRegistration> registrationsIn(const clang::CXXConstructorDecl& constructor,
                                                     const PackagePlaces& places) {
    Collector collector(constructor.getASTContext(), places);
    collector.walk(constructor.getBody(), 0);
    return collector.found;
}

}  // namespace oroforge::cxx
