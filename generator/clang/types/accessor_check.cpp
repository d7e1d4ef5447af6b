// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "accessor_check.hpp"

namespace oroforge::cxx {

/// Replaces the compiler's diagnostic consumer for a while.
class AccessorCheck::FirstError : public clang::DiagnosticConsumer {
public:
    explicit FirstError(clang::DiagnosticsEngine& engine)
        : engine_(engine), outer_(engine.getClient()), owned_(engine.takeClient()) {
        engine_.setClient(this, /*ShouldOwnClient=*/false);
    }
    ~FirstError() override {
        const bool wasOwned = owned_ != nullptr;
        engine_.setClient(wasOwned ? owned_.release() : outer_, wasOwned);
    }
    FirstError(const FirstError&) = delete;
    FirstError& operator=(const FirstError&) = delete;

    void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override {
        if (level < clang::DiagnosticsEngine::Error || !text_.empty()) return;
        llvm::SmallString<128> text;
        info.FormatDiagnostic(text);
        text_ = text.str().str();
    }
    /// Returns the first error; a default text if there was a failure without one.
    std::string text(bool failed) const {
        return !text_.empty() || !failed ? text_ : "it makes no sense to the compiler";
    }

private:
    clang::DiagnosticsEngine& engine_;
    clang::DiagnosticConsumer* outer_;
    std::unique_ptr<clang::DiagnosticConsumer> owned_;
    std::string text_;
};

clang::QualType Accessed::valueType() const { return expression->getType().getCanonicalType().getUnqualifiedType(); }

bool Accessed::isPlace() const {
    return expression->isLValue() && !expression->getType().isConstQualified() &&
           !expression->getType().isVolatileQualified() && !expression->refersToBitField() &&
           !expression->refersToVectorElement();
}

AccessorCheck::AccessorCheck(clang::Sema& sema, const clang::CXXRecordDecl& type)
    : sema_(sema), context_(sema.getASTContext()), type_(context_.getTypeDeclType(&type)), at_(type.getLocation()) {
    sema_.PushExpressionEvaluationContext(clang::Sema::ExpressionEvaluationContext::Unevaluated);
}

AccessorCheck::~AccessorCheck() { sema_.PopExpressionEvaluationContext(); }

clang::Expr* AccessorCheck::makeObject(clang::QualType type) {
    return new (context_) clang::OpaqueValueExpr(at_, type, clang::VK_LValue);
}

clang::ExprResult AccessorCheck::apply(clang::Expr* base, const adapters::Step& step, clang::QualType value) {
    if (step.kind == adapters::Step::Kind::Name) {
        const clang::DeclarationNameInfo name(&context_.Idents.get(step.name), at_);
        clang::CXXScopeSpec scope;
        return sema_.BuildMemberReferenceExpr(base, base->getType(), at_, /*IsArrow=*/false, scope, {}, nullptr, name,
                                              nullptr, nullptr);
    }
    llvm::SmallVector<clang::Expr*, 4> arguments;
    for (const std::string& word : step.arguments) {
        if (word == "value") {
            arguments.push_back(makeObject(value.withConst()));
        } else if (const auto known = words_.find(word); known != words_.end()) {
            arguments.push_back(makeObject(known->second.withConst()));
        } else if (std::isdigit(static_cast<unsigned char>(word[0])) != 0) {
            const llvm::APInt number(context_.getIntWidth(context_.IntTy), std::stoul(word));
            arguments.push_back(clang::IntegerLiteral::Create(context_, number, context_.IntTy, at_));
        } else {
            arguments.push_back(makeObject(context_.getSizeType().withConst()));
        }
    }
    if (step.kind == adapters::Step::Kind::Call) return sema_.BuildCallExpr(nullptr, base, at_, arguments, at_);
    return sema_.ActOnArraySubscriptExpr(nullptr, base, at_, arguments, at_);
}

Accessed AccessorCheck::access(const adapters::Accessor& accessor, bool isConst, clang::QualType value) {
    FirstError errors(context_.getDiagnostics());
    clang::ExprResult made = makeObject(isConst ? type_.withConst() : type_);
    for (const adapters::Step& step : accessor.steps) {
        // A function has no value; only its call has.
        if (made.isUsable() && step.kind != adapters::Step::Kind::Call) made = sema_.CheckPlaceholderExpr(made.get());
        if (made.isUsable()) made = apply(made.get(), step, value);
        if (!made.isUsable()) break;
    }
    if (made.isUsable()) made = sema_.CheckPlaceholderExpr(made.get());
    const bool failed = !made.isUsable() || made.get()->containsErrors() || !errors.text(false).empty();
    Accessed result;
    if (failed)
        result.error = errors.text(true);
    else
        result.expression = made.get();
    return result;
}

std::string AccessorCheck::construct(const std::vector<clang::QualType>& arguments) {
    FirstError errors(context_.getDiagnostics());
    llvm::SmallVector<clang::Expr*, 4> values;
    for (const clang::QualType argument : arguments) values.push_back(makeObject(argument.withConst()));
    const clang::ExprResult made = sema_.BuildCXXTypeConstructExpr(context_.getTrivialTypeSourceInfo(type_, at_), at_,
                                                                   values, at_, /*ListInitialization=*/false);
    return errors.text(!made.isUsable() || made.get()->containsErrors());
}

std::string AccessorCheck::makesValue(const Accessed& made) {
    const auto* call = llvm::dyn_cast<clang::CallExpr>(made.expression->IgnoreImplicit());
    const auto* function =
        call != nullptr ? llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call->getCalleeDecl()) : nullptr;
    if (function == nullptr || !function->isStatic()) return "expected the call of a static function of the class";
    FirstError errors(context_.getDiagnostics());
    const clang::ExprResult value =
        sema_.PerformCopyInitialization(clang::InitializedEntity::InitializeTemporary(type_), at_, made.expression);
    return errors.text(!value.isUsable() || value.get()->containsErrors());
}

std::string AccessorCheck::assign(const Accessed& target, clang::QualType value) {
    if (!target.expression->isLValue() && context_.hasSameType(target.valueType(), value))
        return "what it returns is a copy, not a reference";
    FirstError errors(context_.getDiagnostics());
    const clang::ExprResult made =
        sema_.BuildBinOp(nullptr, at_, clang::BO_Assign, target.expression, makeObject(value.withConst()));
    return errors.text(!made.isUsable() || made.get()->containsErrors());
}

}  // namespace oroforge::cxx
