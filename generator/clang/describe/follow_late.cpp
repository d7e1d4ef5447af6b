// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Hooks, operations and callbacks may add to the interface, too. They are followed like the constructor, but nothing that
// they do counts: whatever they add is a remark.
#include <clang/base/parse_files.hpp>

#include "follow.hpp"

namespace oroforge::cxx {

namespace {

/// Finds what a lambda with parameters of 'auto' adds, which is no code yet that could be followed.
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

}  // namespace

/// As an instance of what has parameters of 'auto'.
bool Follower::isInvoked(const clang::FunctionDecl& lambda) const {
    const clang::FunctionTemplateDecl* pattern = lambda.getDescribedFunctionTemplate();
    return pattern != nullptr && std::any_of(pattern->spec_begin(), pattern->spec_end(),
                                             [&](const auto* one) { return invoked_.count(one) != 0; });
}

void Follower::invokeLate(const clang::FunctionDecl& function, const Place& self, const std::string& why) {
    steps_ = 0;
    late_ = why;
    undecided_.push_back(why);
    invoke(function, {}, self, /*lambda=*/false);
    undecided_.clear();
}

void Follower::followLate(const clang::CXXRecordDecl& made) {
    dynamic_ = &made;
    eachOwn(made, [&](const clang::CXXRecordDecl& type) {
        for (const clang::CXXMethodDecl* method : type.methods()) {
            if (llvm::isa<clang::CXXConstructorDecl, clang::CXXDestructorDecl>(method)) continue;
            const clang::FunctionDecl* definition = definitionOf(*method);
            // Where a derived class has another one, only that calls it.
            if (definition == nullptr || invoked_.count(definition) != 0 || &overriderOf(*method, kRoot) != method)
                continue;
            invokeLate(*definition, kRoot,
                       "in '" + method->getNameAsString() + "', which is not called while the component is made");
        }
    });
    // Those that hooks have made are met there.
    const auto lambdas = lambdas_;
    for (const auto& [function, self] : lambdas) {
        const clang::FunctionDecl* definition = definitionOf(*function);
        if (definition == nullptr || invoked_.count(definition) != 0) continue;
        const std::string which = "in a lambda that may be called later";
        if (!definition->isDependentContext()) {
            invokeLate(*definition, self, which);
        } else if (!isInvoked(*definition)) {
            VerbFinder finder([&](const clang::Expr& at, const std::string& verb) {
                hasMore_ = true;
                remarks_.warning(locate(at.getExprLoc()), "OC022",
                                 "what '" + verb + "' adds here is left out: it is " + which);
            });
            finder.TraverseStmt(definition->getBody());
        }
    }
}

}  // namespace oroforge::cxx
