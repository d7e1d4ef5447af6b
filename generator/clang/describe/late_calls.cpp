// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Hooks, operations and callbacks may also add to the interface. They are followed like the constructor, but anything
// they add is only a remark.
#include "evaluator.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

/// Finds what a generic lambda adds: without an instance it cannot be followed.
class VerbFinder : public clang::RecursiveASTVisitor<VerbFinder> {
public:
    using Report = std::function<void(const clang::Expr&, const std::string&)>;
    explicit VerbFinder(Report report) : report_(std::move(report)) {}
    bool VisitMemberExpr(clang::MemberExpr* one) { return take(*one, one->getMemberDecl()->getNameAsString()); }
    bool VisitOverloadExpr(clang::OverloadExpr* one) { return take(*one, one->getName().getAsString()); }
    bool VisitCXXDependentScopeMemberExpr(clang::CXXDependentScopeMemberExpr* one) {
        return take(*one, one->getMember().getAsString());
    }

private:
    bool take(const clang::Expr& at, const std::string& name) {
        static const std::set<std::string> verbs = {"addPort",      "addEventPort", "addLocalPort",      "addProperty",
                                                    "addAttribute", "addConstant",  "addOperation",      "addService",
                                                    "ownProperty",  "setValue",     "addOperationCaller"};
        if (verbs.count(name) != 0) report_(at, name);
        return true;
    }

    Report report_;
};

class LateCalls : Part {
public:
    explicit LateCalls(const Part& parts) : Part(parts) {}
    void follow(const clang::CXXRecordDecl& made);

private:
    void invoke(const clang::FunctionDecl& function, const Place& self, const std::string& why);
};

void LateCalls::invoke(const clang::FunctionDecl& function, const Place& self, const std::string& why) {
    stack_.countAnew();
    findings_.beLate(why);
    findings_.doubt(why);
    calls_.invoke(function, {}, self);
    findings_.settleTo(0);
}

void LateCalls::follow(const clang::CXXRecordDecl& made) {
    stack_.become(&made);
    eachOwn(made, [&](const clang::CXXRecordDecl& type) {
        for (const clang::CXXMethodDecl* method : type.methods()) {
            if (llvm::isa<clang::CXXConstructorDecl, clang::CXXDestructorDecl>(method)) continue;
            const clang::FunctionDecl* definition = definitionOf(*method);
            // A function that a derived class overrides is called only from there.
            if (definition == nullptr || calls_.isInvoked(*definition) ||
                &stack_.overriderOf(*method, Place::component()) != method)
                continue;
            invoke(*definition, Place::component(),
                   "in '" + method->getNameAsString() + "', which is not called while the component is made");
        }
    });
    // These include lambdas made in hooks.
    const auto lambdas = values_.lambdas();
    for (const auto& [function, self] : lambdas) {
        const clang::FunctionDecl* definition = definitionOf(*function);
        if (definition == nullptr || calls_.isInvoked(*definition)) continue;
        const std::string which = "in a lambda that may be called later";
        if (!definition->isDependentContext()) {
            invoke(*definition, self, which);
            continue;
        }
        VerbFinder finder([&](const clang::Expr& at, const std::string& verb) {
            findings_.noteMore();
            findings_.warn(findings_.locate(at.getExprLoc()), "OC022",
                           "what '" + verb + "' adds here is left out: it is " + which);
        });
        finder.TraverseStmt(definition->getBody());
    }
}

}  // namespace

void followLate(const Part& parts, const clang::CXXRecordDecl& made) { LateCalls(parts).follow(made); }

}  // namespace oroforge::cxx
