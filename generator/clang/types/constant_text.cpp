// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "constant_text.hpp"

#include "cpp_type_text.hpp"

namespace oroforge::cxx {

namespace {

/// Finds anything that makes the meaning of a text depend on its place.
class NameFinder : public clang::RecursiveASTVisitor<NameFinder> {
public:
    bool found = false;
    bool VisitDeclRefExpr(clang::DeclRefExpr*) { return !(found = true); }
    bool VisitMemberExpr(clang::MemberExpr*) { return !(found = true); }
    bool VisitCXXThisExpr(clang::CXXThisExpr*) { return !(found = true); }
    bool VisitLambdaExpr(clang::LambdaExpr*) { return !(found = true); }
    bool VisitExpr(clang::Expr* expression) { return !(found = found || expression->getBeginLoc().isMacroID()); }
};

std::optional<std::string> sourceOf(clang::SourceRange range, const clang::ASTContext& context) {
    const clang::SourceManager& sources = context.getSourceManager();
    const auto whole = clang::CharSourceRange::getTokenRange(range);
    bool invalid = false;
    const llvm::StringRef text = clang::Lexer::getSourceText(whole, sources, context.getLangOpts(), &invalid);
    if (invalid || text.empty() || text.contains('\n')) return std::nullopt;
    return text.str();
}

}  // namespace

std::optional<std::string> constantText(clang::QualType type, const clang::Expr& init,
                                        const clang::ASTContext& context) {
    NameFinder names;
    names.TraverseStmt(const_cast<clang::Expr*>(&init));
    if (names.found) return std::nullopt;
    if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(&init)) {
        const clang::InitListExpr* written =
            list->isSyntacticForm() || !list->getSyntacticForm() ? list : list->getSyntacticForm();
        return sourceOf(written->getSourceRange(), context);
    }
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(&init);
    if (made == nullptr) return std::nullopt;
    std::string arguments;
    for (const clang::Expr* argument : made->arguments()) {
        if (llvm::isa<clang::CXXDefaultArgExpr>(argument)) break;
        const auto text = sourceOf(argument->getSourceRange(), context);
        if (!text) return std::nullopt;
        arguments += (arguments.empty() ? "" : ", ") + *text;
    }
    // A list of elements already has braces.
    const bool braced = made->isListInitialization() && !made->isStdInitListInitialization();
    if (made->isStdInitListInitialization()) return arguments;
    return braced ? "{" + arguments + "}" : cppTypeText(type.getUnqualifiedType(), context) + "(" + arguments + ")";
}

}  // namespace oroforge::cxx
