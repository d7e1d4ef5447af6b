// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/parse_files.hpp>
#include <clang/base/type_names.hpp>
#include <clang/types/constant_text.hpp>

#include "follow.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;
using Kind = Value::Kind;

/// What is around an initialiser without changing what it means.
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

void Follower::initialise(const Place& at, clang::QualType type, const clang::Expr* init) {
    init = bare(init);
    if (type->isReferenceType()) {
        memory_[at] = eval(init);
        return;
    }
    if (const auto* list = dyn_cast<clang::InitListExpr>(init)) return initialiseList(at, type, *list);
    if (const auto* array = context_.getAsConstantArrayType(type)) {
        if (const auto* one = dyn_cast<clang::CXXConstructExpr>(init)) {
            const std::uint64_t size = std::min<std::uint64_t>(array->getSize().getZExtValue(), 1000);
            for (std::uint64_t i = 0; i != size; ++i)
                construct(at + "[" + std::to_string(i) + "]", array->getElementType(), *one);
        } else {
            memory_[at] = eval(init);  // a string
        }
        return;
    }
    if (!type->isRecordType() || isPointerLike(type) || isStdString(type)) {
        if (const auto* one = dyn_cast<clang::CXXConstructExpr>(init)) return construct(at, type, *one);
        if (llvm::isa<clang::ImplicitValueInitExpr, clang::CXXScalarValueInitExpr>(init)) return;
        const Value value = eval(init);
        memory_[at] = init->isGLValue() ? load(value) : value;
        return;
    }
    if (const auto* one = dyn_cast<clang::CXXConstructExpr>(init)) return construct(at, type, *one);
    const Value value = eval(init);
    if (value.is(Kind::Place)) {
        copyObject(value.text, at);
    } else {
        memory_[at] = value;
    }
}

void Follower::initialiseList(const Place& at, clang::QualType type, const clang::InitListExpr& list) {
    if (type->isArrayType() || list.getType()->isArrayType()) {
        const auto* array = context_.getAsArrayType(list.getType());
        for (unsigned i = 0; i != list.getNumInits(); ++i)
            initialise(at + "[" + std::to_string(i) + "]", array->getElementType(), list.getInit(i));
        memory_[at + "#size"] = Value::ofNumber(list.getNumInits());
        return;
    }
    const auto* record = type->getAsCXXRecordDecl();
    if (record == nullptr || isPointerLike(type)) {
        // A number in braces, or none.
        if (list.getNumInits() == 1) initialise(at, type, list.getInit(0));
        return;
    }
    if (list.getNumInits() == 1 && context_.hasSameUnqualifiedType(list.getInit(0)->getType(), type))
        return initialise(at, type, list.getInit(0));
    if (list.getNumInits() != 0) {
        if (const Value whole = constantObject(type, list); whole.known()) memory_[at] = whole;
    }
    unsigned i = 0;
    for (const clang::CXXBaseSpecifier& base : record->bases()) {
        if (i < list.getNumInits()) initialise(at, base.getType(), list.getInit(i++));
    }
    const bool isArray = isStandard(*record, "array");
    for (const clang::FieldDecl* field : record->fields()) {
        if (field->isUnnamedBitField() || i >= list.getNumInits()) continue;
        // The elements of std::array are those of its only field.
        const Place part = isArray ? at : at + "." + field->getNameAsString();
        initialise(part, field->getType(), list.getInit(i++));
    }
}

void Follower::construct(const Place& at, clang::QualType type, const clang::CXXConstructExpr& expression) {
    const clang::CXXConstructorDecl& constructor = *expression.getConstructor();
    if (type->isArrayType()) type = context_.getBaseElementType(type);
    if (constructor.isCopyOrMoveConstructor() && expression.getNumArgs() >= 1) {
        const clang::Expr* source = expression.getArg(0);
        const Value from = eval(source);
        const bool isValue = isPointerLike(type) || isStdString(type);
        if (isValue || !from.is(Kind::Place)) {
            memory_[at] = load(from);
        } else {
            if (const auto known = elements_.find(from.text); known != elements_.end()) elements_[at] = known->second;
            copyObject(from.text, at);
        }
        return;
    }
    Values arguments;
    for (const clang::Expr* argument : expression.arguments()) {
        arguments.push_back(eval(argument));
        // What RTT itself takes if nobody gives anything: "none", whatever it is.
        const bool given = !llvm::isa<clang::CXXDefaultArgExpr>(argument);
        if (!given && !load(arguments.back()).known() && isLibrary(constructor)) arguments.back() = Value::null();
    }
    if (isStdString(type)) {
        const bool plain = arguments.size() <= 1 || llvm::isa<clang::CXXDefaultArgExpr>(expression.getArg(1));
        const Value text = arguments.empty() ? Value::ofText("") : load(arguments[0]);
        memory_[at] = plain && text.is(Kind::Text) ? text : Value();
        return;
    }
    if (isPointerLike(type)) {
        memory_[at] = arguments.empty()                    ? Value::null()
                      : load(arguments[0]).is(Kind::Place) ? load(arguments[0])
                                                           : arguments[0];
        return;
    }
    if (constructKnown(at, type, &constructor, arguments, expression.getBeginLoc())) return;
    if (isStandard(*constructor.getParent(), "pair") && arguments.size() == 2) {
        store(at + ".first", arguments[0]);
        store(at + ".second", arguments[1]);
        return;
    }
    if (isTextStream(type)) {
        const bool hasText = !arguments.empty() && isStdString(constructor.getParamDecl(0)->getType());
        memory_[at + "#text"] = hasText ? Value() : Value::ofText("");
    }
    if (isLibrary(constructor) && !isStandard(*constructor.getParent(), "array")) {
        if (isSequence(type)) constructContainer(at, arguments);
        if (!arguments.empty()) memory_[at] = constantObject(type, expression);
        // Containers that were made of a list are known to have that many elements.
        if (!arguments.empty() && arguments[0].is(Kind::Place) && memory_.count(arguments[0].text + "#size") != 0) {
            const Value whole = memory_[at];
            copyObject(arguments[0].text, at);
            memory_[at] = whole;
        }
        return;
    }
    if (!arguments.empty() && !constructor.isDefaultConstructor())
        if (const Value whole = constantObject(type, expression); whole.known()) memory_[at] = whole;
    construct(at, constructor, arguments);
}

void Follower::construct(const Place& at, const clang::CXXConstructorDecl& declared, const Values& arguments) {
    const auto* constructor = llvm::cast_or_null<clang::CXXConstructorDecl>(definitionOf(declared));
    if (constructor == nullptr && (declared.isImplicit() || declared.isDefaulted())) constructor = &declared;
    const bool matters = at == kRoot || std::any_of(arguments.begin(), arguments.end(), [&](const Value& value) {
                             return value.is(Kind::Place) && scopes_.count(value.text) != 0;
                         });
    if (constructor == nullptr) {
        unseenObjects_[at] = &declared;
        if (!matters) return;
        unseen_.insert(&declared);
        hasMore_ |= late_.empty();
        remark(declared.getLocation(), "OC023",
               "the constructor of '" + shownName(*declared.getParent()) + "' is in none of the files");
        return;
    }
    if (isTooDeep(constructor->getLocation())) return;
    Frame frame;
    frame.self = at;
    bind(*constructor, arguments, frame);
    frames_.push_back(std::move(frame));
    const std::size_t undecided = undecided_.size();
    for (const clang::CXXCtorInitializer* init : constructor->inits()) {
        if (init->isAnyMemberInitializer()) {
            const clang::FieldDecl* field = init->getAnyMember();
            const Place part =
                isStandard(*constructor->getParent(), "array") ? at : at + "." + field->getNameAsString();
            initialise(part, field->getType(), init->getInit());
        } else {
            constructBase(at, *init, arguments);
        }
    }
    const clang::CXXRecordDecl* outer = dynamic_;
    if (at == kRoot) dynamic_ = constructor->getParent();
    if (constructor->getBody() != nullptr) run(constructor->getBody());
    dynamic_ = outer;
    undecided_.resize(undecided);
    frames_.pop_back();
}

/// A base class, or the other constructor that this one leaves the work to.
void Follower::constructBase(const Place& at, const clang::CXXCtorInitializer& init, const Values& inherited) {
    const clang::Expr* expression = bare(init.getInit());
    if (const auto* same = dyn_cast<clang::CXXInheritedCtorInitExpr>(expression)) {
        const clang::CXXConstructorDecl* constructor = same->getConstructor();
        if (!constructKnown(at, context_.getTypeDeclType(constructor->getParent()), constructor, inherited,
                            init.getSourceLocation()))
            construct(at, *constructor, inherited);
        return;
    }
    const auto* one = dyn_cast<clang::CXXConstructExpr>(expression);
    if (one == nullptr) return;
    construct(at, one->getType(), *one);
}

/// A copy of what an argument refers to.
void Follower::store(const Place& at, const Value& value) {
    if (value.is(Kind::Place)) copyObject(value.text, at);
    if (memory_.count(at) == 0) memory_[at] = load(value);
}

Value Follower::make(clang::QualType type, const Values& arguments, clang::SourceLocation where) {
    const auto* record = type.isNull() ? nullptr : type->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition()) return {};
    const Place at = fresh("new");
    makeAt(at, type, arguments, where);
    return Value::ofPlace(at);
}

void Follower::makeAt(const Place& at, clang::QualType type, const Values& arguments, clang::SourceLocation where) {
    const auto* record = type->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition()) return;
    const clang::CXXConstructorDecl* fitting = nullptr;
    for (const clang::CXXConstructorDecl* one : record->getDefinition()->ctors()) {
        const bool fits = arguments.size() >= one->getMinRequiredArguments() && arguments.size() <= one->getNumParams();
        if (fits && !one->isCopyOrMoveConstructor() && fitting == nullptr) fitting = one;
    }
    if (constructKnown(at, type, fitting, arguments, where)) return;
    if (fitting != nullptr && !isLibrary(*fitting)) construct(at, *fitting, arguments);
}

Value Follower::constantObject(clang::QualType type, const clang::Expr& init) const {
    const auto text = constantText(type, init, context_);
    return text ? Value::ofText(*text, Kind::Cpp) : Value();
}

}  // namespace oroforge::cxx
