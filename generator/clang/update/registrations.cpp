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

const clang::Expr* plain(const clang::Expr* value) {
    return value == nullptr ? nullptr : value->IgnoreUnlessSpelledInSource();
}

const clang::StringLiteral* literalOf(const clang::Expr* value) {
    const auto* text = llvm::dyn_cast_or_null<clang::StringLiteral>(plain(value));
    return text != nullptr && text->isOrdinary() ? text : nullptr;
}

/// Adds "gripper" for provides("gripper"). Returns false if the object may be any service.
bool readService(const clang::Expr* object, std::string& service) {
    object = plain(object);
    if (const auto* arrow = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(object))
        return arrow->getOperator() == clang::OO_Arrow && readService(arrow->getArg(0), service);
    if (object == nullptr || llvm::isa<clang::CXXThisExpr>(object)) return true;
    const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(object);
    const auto* callee = call == nullptr ? nullptr : llvm::dyn_cast<clang::MemberExpr>(plain(call->getCallee()));
    if (callee == nullptr || !readService(callee->getBase(), service)) return false;
    const std::string name = callee->getMemberDecl()->getNameAsString();
    if (name == "ports" || name == "properties" || name == "attributes" || name == "operations") return true;
    if (name != "provides") return false;
    if (call->getNumArgs() == 0) return true;
    const clang::StringLiteral* text = literalOf(call->getArg(0));
    if (text == nullptr) return false;
    service += (service.empty() ? "" : ".") + text->getString().str();
    return true;
}

class Collector {
public:
    Collector(const clang::ASTContext& context, const PackagePlaces& places, bool inConstructor)
        : context_(context), places_(places), inConstructor_(inConstructor) {}

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
        one.verbSpan = {one.receiver.end, places_.offset(behindWord(context_, verb.where))};
        one.isNested = nested || !inConstructor_;
        if (call->getNumArgs() > 0) one.literal = firstString(call->getArg(0));
        for (const clang::Expr* argument : call->arguments()) {
            if (one.member.empty()) one.member = memberIn(argument);
            readThread(argument, one);
        }
        const auto* callee = llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParenImpCasts());
        one.knowsService = callee != nullptr && readService(callee->getBase(), one.service);
        one.arguments = call->getNumArgs();
        one.callEnd = places_.offset(behindWord(context_, call->getRParenLoc()));
        one.textsKnown = readTexts(&expression, call, one);
        if (!one.file.empty()) found.push_back(std::move(one));
    }

    void readThread(const clang::Expr* argument, model::UserRegistration& into) const {
        const auto* name = llvm::dyn_cast_or_null<clang::DeclRefExpr>(plain(argument));
        if (name == nullptr || !llvm::isa<clang::EnumConstantDecl>(name->getDecl())) return;
        const std::string word = name->getDecl()->getNameAsString();
        if ((word != "OwnThread" && word != "ClientThread") || name->getLocation().isMacroID()) return;
        into.thread = word;
        into.threadSpan = {places_.offset(name->getLocation()),
                           places_.offset(behindWord(context_, name->getLocation()))};
    }

    /// Reads the calls of doc() and arg() around `call`. Returns false if there is anything else.
    bool readTexts(const clang::Expr* whole, const clang::CallExpr* call, model::UserRegistration& into) const {
        whole = plain(whole);
        if (whole == call) return true;
        const auto* outer = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(whole);
        const auto* callee = outer == nullptr ? nullptr : llvm::dyn_cast<clang::MemberExpr>(plain(outer->getCallee()));
        if (callee == nullptr || callee->getOperatorLoc().isMacroID() || !readTexts(callee->getBase(), call, into))
            return false;
        const std::string name = callee->getMemberDecl()->getNameAsString();
        const unsigned count = outer->getNumArgs();
        model::UserText text;
        if (name == "arg" && count == 2 && literalOf(outer->getArg(0)) != nullptr) {
            text.argument = literalOf(outer->getArg(0))->getString().str();
        } else if (name != "doc" || count != 1) {
            return false;
        }
        text.call = {places_.offset(callee->getOperatorLoc()),
                     places_.offset(behindWord(context_, outer->getRParenLoc()))};
        const clang::StringLiteral* words = literalOf(outer->getArg(count - 1));
        if (words == nullptr) return false;
        text.words = words->getString().str();
        if (!words->getBeginLoc().isMacroID() && !words->getEndLoc().isMacroID())
            text.literal = {places_.offset(words->getBeginLoc()),
                            places_.offset(behindWord(context_, words->getEndLoc()))};
        into.texts.push_back(std::move(text));
        return true;
    }

    const clang::ASTContext& context_;
    const PackagePlaces& places_;
    const bool inConstructor_;
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

std::vector<model::UserRegistration> registrationsIn(const clang::CXXMethodDecl& method, const PackagePlaces& places) {
    Collector collector(method.getASTContext(), places, llvm::isa<clang::CXXConstructorDecl>(method));
    collector.walk(method.getBody(), 0);
    return collector.found;
}

}  // namespace oroforge::cxx
