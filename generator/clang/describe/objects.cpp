// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/parse_files.hpp>
#include <clang/base/type_names.hpp>
#include <clang/types/constant_text.hpp>

#include "evaluator.hpp"
#include "interface_calls.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;
using Kind = Value::Kind;

/// Removes wrappers around an initialiser that do not change its meaning.
const clang::Expr* bare(const clang::Expr* init) {
    for (;;) {
        const clang::Expr* before = init;
        init = init->IgnoreParens();
        if (const auto* full = dyn_cast<clang::FullExpr>(init)) init = full->getSubExpr();
        if (const auto* bound = dyn_cast<clang::CXXBindTemporaryExpr>(init)) init = bound->getSubExpr();
        if (const auto* given = dyn_cast<clang::CXXDefaultInitExpr>(init)) init = given->getExpr();
        if (const auto* made = dyn_cast<clang::CXXFunctionalCastExpr>(init))
            if (made->getType()->isRecordType()) init = made->getSubExpr();
        if (const auto* made = dyn_cast<clang::ImplicitCastExpr>(init))
            if (made->getCastKind() == clang::CK_ConstructorConversion) init = made->getSubExpr();
        if (const auto* list = dyn_cast<clang::CXXStdInitializerListExpr>(init)) init = list->getSubExpr();
        if (init == before) return init;
    }
}

}  // namespace

void Objects::initialise(const Place& at, clang::QualType type, const clang::Expr* init) {
    init = bare(init);
    if (type->isReferenceType()) {
        memory_.set(at, values_.eval(init));
        return;
    }
    if (const auto* list = dyn_cast<clang::InitListExpr>(init)) return initialiseList(at, type, *list);
    if (const auto* array = context_.getAsConstantArrayType(type)) {
        if (const auto* one = dyn_cast<clang::CXXConstructExpr>(init)) {
            const std::uint64_t size = std::min<std::uint64_t>(array->getSize().getZExtValue(), 1000);
            for (std::uint64_t i = 0; i != size; ++i) construct(at.element(i), array->getElementType(), *one);
        } else {
            memory_.set(at, values_.eval(init));  // a string
        }
        return;
    }
    if (!type->isRecordType() || isPointerLike(type) || isStdString(type)) {
        if (const auto* one = dyn_cast<clang::CXXConstructExpr>(init)) return construct(at, type, *one);
        if (llvm::isa<clang::ImplicitValueInitExpr, clang::CXXScalarValueInitExpr>(init)) return;
        const Value value = values_.eval(init);
        memory_.set(at, init->isGLValue() ? memory_.load(value) : value);
        return;
    }
    if (const auto* one = dyn_cast<clang::CXXConstructExpr>(init)) return construct(at, type, *one);
    const Value value = values_.eval(init);
    if (value.is(Kind::Place)) {
        memory_.copy(value.place, at);
    } else {
        memory_.set(at, value);
    }
}

void Objects::initialiseList(const Place& at, clang::QualType type, const clang::InitListExpr& list) {
    if (type->isArrayType() || list.getType()->isArrayType()) {
        const auto* array = context_.getAsArrayType(list.getType());
        for (unsigned i = 0; i != list.getNumInits(); ++i)
            initialise(at.element(i), array->getElementType(), list.getInit(i));
        memory_.set(at.of(Place::Kind::Size), Value::ofNumber(list.getNumInits()));
        return;
    }
    const auto* record = type->getAsCXXRecordDecl();
    if (record == nullptr || isPointerLike(type)) {
        // One number in braces, or empty braces.
        if (list.getNumInits() == 1) initialise(at, type, list.getInit(0));
        return;
    }
    if (list.getNumInits() == 1 && context_.hasSameUnqualifiedType(list.getInit(0)->getType(), type))
        return initialise(at, type, list.getInit(0));
    if (list.getNumInits() != 0) {
        if (const Value whole = constantObject(type, list); whole.known()) memory_.set(at, whole);
    }
    unsigned i = 0;
    for (const clang::CXXBaseSpecifier& base : record->bases()) {
        if (i < list.getNumInits()) initialise(at, base.getType(), list.getInit(i++));
    }
    const bool isArray = isStandard(*record, "array");
    for (const clang::FieldDecl* field : record->fields()) {
        if (field->isUnnamedBitField() || i >= list.getNumInits()) continue;
        // The elements of std::array are those of its only field.
        const Place part = isArray ? at : at.field(field->getNameAsString());
        initialise(part, field->getType(), list.getInit(i++));
    }
}

void Objects::construct(const Place& at, clang::QualType type, const clang::CXXConstructExpr& expression) {
    const clang::CXXConstructorDecl& constructor = *expression.getConstructor();
    if (type->isArrayType()) type = context_.getBaseElementType(type);
    if (constructor.isCopyOrMoveConstructor() && expression.getNumArgs() >= 1) {
        const clang::Expr* source = expression.getArg(0);
        const Value from = values_.eval(source);
        const bool isValue = isPointerLike(type) || isStdString(type);
        if (isValue || !from.is(Kind::Place)) {
            memory_.set(at, memory_.load(from));
        } else {
            if (const Element* known = registry_.elementAt(from.place)) registry_.elements[at] = *known;
            memory_.copy(from.place, at);
        }
        return;
    }
    Values arguments;
    for (const clang::Expr* argument : expression.arguments()) {
        arguments.push_back(values_.eval(argument));
        // RTT's own default argument means "none", whatever it is.
        const bool given = !llvm::isa<clang::CXXDefaultArgExpr>(argument);
        if (!given && !memory_.load(arguments.back()).known() && isLibrary(constructor))
            arguments.back() = Value::null();
    }
    if (isStdString(type)) {
        const bool plain = arguments.size() <= 1 || llvm::isa<clang::CXXDefaultArgExpr>(expression.getArg(1));
        const Value text = arguments.empty() ? Value::ofText("") : memory_.load(arguments[0]);
        memory_.set(at, plain && text.is(Kind::Text) ? text : Value());
        return;
    }
    if (isPointerLike(type)) {
        memory_.set(at, arguments.empty()                            ? Value::null()
                        : memory_.load(arguments[0]).is(Kind::Place) ? memory_.load(arguments[0])
                                                                     : arguments[0]);
        return;
    }
    if (known_.construct(at, type, &constructor, arguments, expression.getBeginLoc())) return;
    if (isStandard(*constructor.getParent(), "pair") && arguments.size() == 2) {
        memory_.store(at.field("first"), arguments[0]);
        memory_.store(at.field("second"), arguments[1]);
        return;
    }
    if (isTextStream(type)) {
        const bool hasText = !arguments.empty() && isStdString(constructor.getParamDecl(0)->getType());
        memory_.set(at.of(Place::Kind::Text), hasText ? Value() : Value::ofText(""));
    }
    if (isLibrary(constructor) && !isStandard(*constructor.getParent(), "array")) {
        if (isSequence(type)) containers_.construct(at, arguments);
        if (!arguments.empty()) memory_.set(at, constantObject(type, expression));
        // A container made from a list has that number of elements.
        if (!arguments.empty() && arguments[0].is(Kind::Place) &&
            memory_.find(arguments[0].place.of(Place::Kind::Size)) != nullptr) {
            const Value whole = memory_.load(Value::ofPlace(at));
            memory_.copy(arguments[0].place, at);
            memory_.set(at, whole);
        }
        return;
    }
    if (!arguments.empty() && !constructor.isDefaultConstructor())
        if (const Value whole = constantObject(type, expression); whole.known()) memory_.set(at, whole);
    construct(at, constructor, arguments);
}

void Objects::construct(const Place& at, const clang::CXXConstructorDecl& declared, const Values& arguments) {
    const auto* constructor = llvm::cast_or_null<clang::CXXConstructorDecl>(definitionOf(declared));
    if (constructor == nullptr && (declared.isImplicit() || declared.isDefaulted())) constructor = &declared;
    const bool matters = at.isComponent() || std::any_of(arguments.begin(), arguments.end(), [&](const Value& value) {
                             return value.is(Kind::Place) && registry_.scopes.count(value.place) != 0;
                         });
    if (constructor == nullptr) {
        unseen_[at] = &declared;
        if (!matters) return;
        findings_.noteUnseen(declared);
        findings_.noteMore(!findings_.isLate());
        findings_.remark(declared.getLocation(), "OC023",
                         "the constructor of '" + shownName(*declared.getParent()) + "' is in none of the files");
        return;
    }
    if (stack_.isTooDeep(constructor->getLocation())) return;
    stack_.enter(calls_.frameOf(*constructor, arguments, at));
    for (const clang::CXXCtorInitializer* init : constructor->inits()) {
        if (init->isAnyMemberInitializer()) {
            const clang::FieldDecl* field = init->getAnyMember();
            const Place part = isStandard(*constructor->getParent(), "array") ? at : at.field(field->getNameAsString());
            initialise(part, field->getType(), init->getInit());
        } else {
            constructBase(at, *init, arguments);
        }
    }
    const clang::CXXRecordDecl* outer = stack_.become(at.isComponent() ? constructor->getParent() : stack_.type());
    statements_.run(constructor->getBody());
    stack_.become(outer);
    stack_.leave();
}

/// Follows a base class's constructor, or another constructor of the class to which this one delegates.
void Objects::constructBase(const Place& at, const clang::CXXCtorInitializer& init, const Values& inherited) {
    const clang::Expr* expression = bare(init.getInit());
    if (const auto* same = dyn_cast<clang::CXXInheritedCtorInitExpr>(expression)) {
        const clang::CXXConstructorDecl* constructor = same->getConstructor();
        if (!known_.construct(at, context_.getTypeDeclType(constructor->getParent()), constructor, inherited,
                              init.getSourceLocation()))
            construct(at, *constructor, inherited);
        return;
    }
    const auto* one = dyn_cast<clang::CXXConstructExpr>(expression);
    if (one == nullptr) return;
    construct(at, one->getType(), *one);
}

Value Objects::make(clang::QualType type, const Values& arguments, clang::SourceLocation where) {
    const auto* record = type.isNull() ? nullptr : type->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition()) return {};
    const Place at = memory_.fresh();
    makeAt(at, type, arguments, where);
    return Value::ofPlace(at);
}

void Objects::makeAt(const Place& at, clang::QualType type, const Values& arguments, clang::SourceLocation where) {
    const auto* record = type->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition()) return;
    const clang::CXXConstructorDecl* fitting = nullptr;
    for (const clang::CXXConstructorDecl* one : record->getDefinition()->ctors()) {
        const bool fits = arguments.size() >= one->getMinRequiredArguments() && arguments.size() <= one->getNumParams();
        if (fits && !one->isCopyOrMoveConstructor() && fitting == nullptr) fitting = one;
    }
    if (known_.construct(at, type, fitting, arguments, where)) return;
    if (fitting != nullptr && !isLibrary(*fitting)) construct(at, *fitting, arguments);
}

const clang::FunctionDecl* Objects::unseenMaker(const Place& place) const {
    for (const auto& [object, constructor] : unseen_) {
        if (place.isInFieldOf(object)) return constructor;
    }
    return nullptr;
}

Value Objects::constantObject(clang::QualType type, const clang::Expr& init) const {
    const auto text = constantText(type, init, context_);
    return text ? Value::ofText(*text, Kind::Cpp) : Value();
}

}  // namespace oroforge::cxx
