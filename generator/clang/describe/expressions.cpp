// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <cmath>

#include "evaluator.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using clang::BinaryOperatorKind;
using llvm::dyn_cast;
using Kind = Value::Kind;

bool isNumeric(const Value& value) { return value.is(Kind::Number) || value.is(Kind::Real) || value.is(Kind::Boolean); }
double realOf(const Value& value) { return value.is(Kind::Real) ? value.real : static_cast<double>(value.number); }

template <class Number>
Value compared(BinaryOperatorKind kind, Number left, Number right) {
    switch (kind) {
        case clang::BO_LT: return Value::ofBoolean(left < right);
        case clang::BO_GT: return Value::ofBoolean(left > right);
        case clang::BO_LE: return Value::ofBoolean(left <= right);
        case clang::BO_GE: return Value::ofBoolean(left >= right);
        case clang::BO_EQ: return Value::ofBoolean(left == right);
        case clang::BO_NE: return Value::ofBoolean(left != right);
        default: return {};
    }
}

Value computed(BinaryOperatorKind kind, double left, double right) {
    switch (kind) {
        case clang::BO_Add: return Value::ofReal(left + right);
        case clang::BO_Sub: return Value::ofReal(left - right);
        case clang::BO_Mul: return Value::ofReal(left * right);
        case clang::BO_Div: return Value::ofReal(left / right);
        default: return compared(kind, left, right);
    }
}

Value computed(BinaryOperatorKind kind, long long left, long long right) {
    // Computes unsigned numbers: the user's code may overflow, but that must not be undefined here.
    const auto a = static_cast<unsigned long long>(left), b = static_cast<unsigned long long>(right);
    const auto of = [](unsigned long long value) { return Value::ofNumber(static_cast<long long>(value)); };
    const bool divides = right != 0 && !(right == -1 && left == std::numeric_limits<long long>::min());
    switch (kind) {
        case clang::BO_Add: return of(a + b);
        case clang::BO_Sub: return of(a - b);
        case clang::BO_Mul: return of(a * b);
        case clang::BO_Div: return divides ? Value::ofNumber(left / right) : Value();
        case clang::BO_Rem: return divides ? Value::ofNumber(left % right) : Value();
        case clang::BO_And: return of(a & b);
        case clang::BO_Or: return of(a | b);
        case clang::BO_Xor: return of(a ^ b);
        case clang::BO_Shl: return b < 64 ? of(a << b) : Value();
        case clang::BO_Shr: return b < 64 ? Value::ofNumber(left >> right) : Value();
        default: return compared(kind, left, right);
    }
}

Value operated(BinaryOperatorKind kind, const Value& left, const Value& right) {
    if (!isNumeric(left) || !isNumeric(right)) return {};
    if (left.is(Kind::Real) || right.is(Kind::Real)) return computed(kind, realOf(left), realOf(right));
    return computed(kind, left.number, right.number);
}

}  // namespace

Value Expressions::eval(const clang::Expr* expression) {
    if (expression == nullptr || stack_.isTooMuch(expression->getBeginLoc())) return {};
    expression = expression->IgnoreParens();
    if (const auto* full = dyn_cast<clang::FullExpr>(expression)) return eval(full->getSubExpr());
    if (const auto* bound = dyn_cast<clang::CXXBindTemporaryExpr>(expression)) return eval(bound->getSubExpr());
    if (const auto* given = dyn_cast<clang::SubstNonTypeTemplateParmExpr>(expression))
        return eval(given->getReplacement());
    if (const auto* given = dyn_cast<clang::CXXDefaultArgExpr>(expression)) return eval(given->getExpr());
    if (const auto* given = dyn_cast<clang::CXXDefaultInitExpr>(expression)) return eval(given->getExpr());
    if (const auto* list = dyn_cast<clang::CXXStdInitializerListExpr>(expression)) return eval(list->getSubExpr());
    if (const auto* temporary = dyn_cast<clang::MaterializeTemporaryExpr>(expression)) {
        const Value value = eval(temporary->getSubExpr());
        const clang::QualType type = temporary->getType();
        const bool isObject = (type->isRecordType() && !isPointerLike(type)) || type->isArrayType();
        if (isObject && value.is(Kind::Place)) return value;
        const Place place = memory_.fresh();
        memory_.set(place, value);
        return Value::ofPlace(place);
    }
    return evalPlain(expression);
}

Value Expressions::content(const clang::Expr* expression) {
    const Value value = eval(expression);
    return expression->isGLValue() || expression->getType()->isRecordType() ? memory_.load(value) : value;
}

Value Expressions::pointed(const clang::Expr* expression) {
    const Value value = eval(expression);
    return expression->isGLValue() ? memory_.load(value) : value;
}

std::optional<std::string> Expressions::textOf(const clang::Expr* expression) {
    if (expression == nullptr) return std::nullopt;
    const Value value = memory_.load(eval(expression));
    return value.is(Kind::Text) ? std::optional(value.text) : std::nullopt;
}

std::optional<bool> Expressions::truth(const clang::Expr* condition) {
    const Value value = content(condition);
    if (value.is(Kind::Real)) return value.real != 0;
    if (value.is(Kind::Number) || value.is(Kind::Boolean)) return value.number != 0;
    if (value.is(Kind::Null)) return false;
    return std::nullopt;
}

Value Expressions::evalPlain(const clang::Expr* expression) {
    if (const auto* one = dyn_cast<clang::CXXConstructExpr>(expression)) {
        const Place place = memory_.fresh();
        objects_.construct(place, one->getType(), *one);
        // Strings and smart pointers are values; other objects are places.
        const bool isValue = isStdString(one->getType()) || isPointerLike(one->getType());
        return isValue ? memory_.load(Value::ofPlace(place)) : Value::ofPlace(place);
    }
    if (const auto* list = dyn_cast<clang::InitListExpr>(expression)) {
        if (!list->getType()->isRecordType() && !list->getType()->isArrayType())
            return list->getNumInits() == 1 ? eval(list->getInit(0)) : Value::ofNumber(0);
        const Place place = memory_.fresh();
        objects_.initialise(place, list->getType(), list);
        return Value::ofPlace(place);
    }
    if (const auto* one = dyn_cast<clang::CastExpr>(expression)) return cast(*one);
    if (const auto* one = dyn_cast<clang::StringLiteral>(expression))
        return one->isOrdinary() || one->isUTF8() ? Value::ofText(one->getString().str()) : Value();
    if (const auto* one = dyn_cast<clang::DeclRefExpr>(expression)) return declared(*one);
    if (const auto* one = dyn_cast<clang::MemberExpr>(expression)) return member(*one);
    if (llvm::isa<clang::CXXThisExpr>(expression)) return Value::ofPlace(stack_.top().self);
    if (llvm::isa<clang::CXXNullPtrLiteralExpr>(expression)) return Value::null();
    if (const auto* one = dyn_cast<clang::UnaryOperator>(expression)) return unary(*one);
    if (const auto* one = dyn_cast<clang::BinaryOperator>(expression)) return binary(*one);
    if (const auto* one = dyn_cast<clang::ConditionalOperator>(expression)) return conditional(*one);
    if (const auto* one = dyn_cast<clang::CallExpr>(expression)) return calls_.call(*one);
    if (const auto* one = dyn_cast<clang::LambdaExpr>(expression)) {
        Value value = Value::ofText("", Kind::Function);
        value.function = one->getCallOperator();
        lambdas_.emplace_back(value.function, stack_.top().self);
        return value;
    }
    if (const auto* one = dyn_cast<clang::CXXNewExpr>(expression)) {
        const Place place = memory_.fresh();
        if (one->getInitializer() != nullptr)
            objects_.initialise(place, one->getAllocatedType(), one->getInitializer());
        return Value::ofPlace(place);
    }
    if (const auto* one = dyn_cast<clang::ArraySubscriptExpr>(expression)) {
        const Value base = eval(one->getBase()), index = eval(one->getIdx());
        if (!base.is(Kind::Place) || !index.is(Kind::Number)) return {};
        return Value::ofPlace(base.place.element(index.number));
    }
    return folded(expression);
}

/// Takes what the compiler itself can compute; otherwise follows the parts only for their effects.
Value Expressions::folded(const clang::Expr* expression) {
    if (expression->isValueDependent()) return {};
    clang::Expr::EvalResult result;
    const clang::QualType type = expression->getType();
    if ((type->isIntegralOrEnumerationType() || type->isFloatingType()) &&
        expression->EvaluateAsRValue(result, context_) && !result.HasSideEffects) {
        if (result.Val.isFloat()) {
            llvm::APFloat value = result.Val.getFloat();
            bool inexact = false;
            value.convert(llvm::APFloat::IEEEdouble(), llvm::APFloat::rmNearestTiesToEven, &inexact);
            return Value::ofReal(value.convertToDouble());
        }
        if (result.Val.isInt() && result.Val.getInt().getBitWidth() <= 64) {
            const llvm::APSInt& value = result.Val.getInt();
            if (type->isBooleanType()) return Value::ofBoolean(value.getBoolValue());
            return Value::ofNumber(value.isSigned() ? value.getSExtValue()
                                                    : static_cast<long long>(value.getZExtValue()));
        }
    }
    for (const clang::Stmt* part : expression->children()) {
        if (const auto* one = llvm::dyn_cast_or_null<clang::Expr>(part)) eval(one);
    }
    return {};
}

Value Expressions::converted(Value value, clang::QualType type) const {
    if (!isNumeric(value)) return value;
    if (type->isBooleanType()) return Value::ofBoolean(value.is(Kind::Real) ? value.real != 0 : value.number != 0);
    if (type->isFloatingType()) {
        const double real = realOf(value);
        return Value::ofReal(context_.hasSameUnqualifiedType(type, context_.FloatTy) ? static_cast<float>(real) : real);
    }
    if (!type->isIntegralOrEnumerationType()) return {};
    if (value.is(Kind::Real)) {
        if (!(std::fabs(value.real) < 9e18)) return {};
        value = Value::ofNumber(static_cast<long long>(value.real));
    }
    const auto bits = static_cast<unsigned>(context_.getTypeSize(type));
    const llvm::APInt whole(64, static_cast<std::uint64_t>(value.number));
    const llvm::APInt cut = bits >= 64 ? whole : whole.trunc(bits);
    Value result = Value::ofNumber(
        type->isSignedIntegerOrEnumerationType() ? cut.getSExtValue() : static_cast<long long>(cut.getZExtValue()));
    if (type->isEnumeralType()) result.text = value.text;
    return result;
}

Value Expressions::cast(const clang::CastExpr& expression) {
    Value value = eval(expression.getSubExpr());
    switch (expression.getCastKind()) {
        case clang::CK_LValueToRValue: return value.is(Kind::Place) ? memory_.load(value) : value;
        case clang::CK_IntegralCast:
        case clang::CK_FloatingCast:
        case clang::CK_IntegralToFloating:
        case clang::CK_FloatingToIntegral:
        case clang::CK_IntegralToBoolean:
        case clang::CK_FloatingToBoolean: return converted(std::move(value), expression.getType());
        case clang::CK_NullToPointer: return Value::null();
        case clang::CK_PointerToBoolean:
            if (value.is(Kind::Null)) return Value::ofBoolean(false);
            return value.is(Kind::Place) ? Value::ofBoolean(true) : Value();
        case clang::CK_ToVoid: return {};
        // A string made from a literal, or the pointer in a smart pointer, is the same value here.
        case clang::CK_ConstructorConversion:
        case clang::CK_UserDefinedConversion:
        default: return value;
    }
}

Value Expressions::declared(const clang::DeclRefExpr& expression) {
    const clang::ValueDecl* what = expression.getDecl();
    if (const auto* function = dyn_cast<clang::FunctionDecl>(what)) {
        Value value = Value::ofText("", Kind::Function);
        value.function = function;
        return value;
    }
    if (const auto* enumerator = dyn_cast<clang::EnumConstantDecl>(what)) {
        Value value = Value::ofNumber(enumerator->getInitVal().getExtValue());
        const auto* type = dyn_cast<clang::EnumDecl>(enumerator->getDeclContext());
        const std::string own = enumerator->getNameAsString();
        const std::string full = enumerator->getQualifiedNameAsString();
        const bool needsType = type != nullptr && !type->isScoped() && !type->getName().empty();
        value.text = needsType ? type->getQualifiedNameAsString() + "::" + own : full;
        return value;
    }
    if (const auto* binding = dyn_cast<clang::BindingDecl>(what)) {
        // The compiler makes a variable from std::get<…>() for a part of a pair.
        if (const clang::VarDecl* holder = binding->getHoldingVar()) return eval(holder->getInit());
        return binding->getBinding() != nullptr ? eval(binding->getBinding()) : Value();
    }
    if (const auto local = stack_.find(*what)) return Value::ofPlace(*local);
    const auto* variable = dyn_cast<clang::VarDecl>(what);
    if (variable == nullptr) return {};
    // RTT's only constant without a value in its headers; it means "none given".
    if (variable->getName() == "LowestPriority") return Value::null();
    const Place place = Place::global(variable->getCanonicalDecl()->getID());
    const clang::VarDecl* definition = nullptr;
    const clang::Expr* init = variable->getAnyInitializer(definition);
    const bool constant = variable->getType().isConstQualified() || variable->isConstexpr();
    const bool array =
        variable->getType()->isArrayType() && context_.getBaseElementType(variable->getType()).isConstQualified();
    if (init != nullptr && (constant || array) && memory_.find(place.of(Place::Kind::Initialised)) == nullptr) {
        memory_.set(place.of(Place::Kind::Initialised), Value::ofBoolean(true));
        if (variable->getType()->isReferenceType()) return eval(init);
        objects_.initialise(place, variable->getType(), init);
    }
    return Value::ofPlace(place);
}

Value Expressions::member(const clang::MemberExpr& expression) {
    const auto* field = dyn_cast<clang::FieldDecl>(expression.getMemberDecl());
    if (field == nullptr) {
        const auto* variable = dyn_cast<clang::VarDecl>(expression.getMemberDecl());
        eval(expression.getBase());
        if (variable == nullptr || !variable->getType().isConstQualified()) return {};
        const clang::Expr* init = variable->getAnyInitializer();
        const Place place = Place::global(variable->getCanonicalDecl()->getID());
        if (init != nullptr && memory_.find(place) == nullptr) objects_.initialise(place, variable->getType(), init);
        return Value::ofPlace(place);
    }
    const Value base = eval(expression.getBase());
    if (!base.is(Kind::Place)) return {};
    // The fields of a nameless struct or union belong to the class.
    if (field->isAnonymousStructOrUnion()) return base;
    const Place place = base.place.field(field->getNameAsString());
    return field->getType()->isReferenceType() ? memory_.load(Value::ofPlace(place)) : Value::ofPlace(place);
}

Value Expressions::unary(const clang::UnaryOperator& expression) {
    const Value value = eval(expression.getSubExpr());
    const clang::QualType type = expression.getType();
    switch (expression.getOpcode()) {
        case clang::UO_AddrOf:
        case clang::UO_Deref:
        case clang::UO_Extension: return value;
        case clang::UO_Plus: return value;
        case clang::UO_Minus:
            if (value.is(Kind::Real)) return Value::ofReal(-value.real);
            return converted(operated(clang::BO_Sub, Value::ofNumber(0), value), type);
        case clang::UO_Not: return converted(operated(clang::BO_Xor, Value::ofNumber(-1), value), type);
        case clang::UO_LNot: {
            const auto known = isNumeric(value) ? std::optional(value.number != 0 || value.real != 0) : std::nullopt;
            return known ? Value::ofBoolean(!*known) : Value();
        }
        case clang::UO_PreInc:
        case clang::UO_PostInc:
        case clang::UO_PreDec:
        case clang::UO_PostDec: {
            if (!value.is(Kind::Place)) return {};
            const Value before = memory_.load(value);
            const auto kind = expression.isIncrementOp() ? clang::BO_Add : clang::BO_Sub;
            memory_.assign(value.place, converted(operated(kind, before, Value::ofNumber(1)), type));
            return expression.isPrefix() ? value : before;
        }
        default: return {};
    }
}

Value Expressions::binary(const clang::BinaryOperator& expression) {
    const auto kind = expression.getOpcode();
    if (expression.isLogicalOp()) {
        const auto left = truth(expression.getLHS());
        const bool decides = kind == clang::BO_LAnd ? left == false : left == true;
        if (decides) return Value::ofBoolean(*left);
        if (!left) findings_.doubt("behind a condition that is not constant");
        const auto right = truth(expression.getRHS());
        if (!left) findings_.settle();
        const bool decided = kind == clang::BO_LAnd ? right == false : right == true;
        return right && (left || decided) ? Value::ofBoolean(*right) : Value();
    }
    if (kind == clang::BO_Assign) {
        const Value value = eval(expression.getRHS()), target = eval(expression.getLHS());
        if (target.is(Kind::Place)) memory_.assign(target.place, converted(value, expression.getType()));
        return target;
    }
    if (const auto* compound = dyn_cast<clang::CompoundAssignOperator>(&expression)) {
        const Value value = eval(expression.getRHS()), target = eval(expression.getLHS());
        if (!target.is(Kind::Place)) return {};
        const Value before = converted(memory_.load(target), compound->getComputationLHSType());
        memory_.assign(target.place,
                       converted(operated(clang::BinaryOperator::getOpForCompoundAssignment(kind), before, value),
                                 expression.getType()));
        return target;
    }
    const Value left = eval(expression.getLHS()), right = eval(expression.getRHS());
    if (kind == clang::BO_Comma) return right;
    const Value result = operated(kind, left, right);
    return expression.isComparisonOp() ? result : converted(result, expression.getType());
}

Value Expressions::conditional(const clang::ConditionalOperator& expression) {
    const auto decided = truth(expression.getCond());
    if (decided) return eval(*decided ? expression.getTrueExpr() : expression.getFalseExpr());
    findings_.doubt("behind a condition that is not constant");
    eval(expression.getTrueExpr());
    eval(expression.getFalseExpr());
    findings_.settle();
    return {};
}

}  // namespace oroforge::cxx
