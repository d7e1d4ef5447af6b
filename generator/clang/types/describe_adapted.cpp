// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "describe_adapted.hpp"

#include <adapters/name_pattern.hpp>
#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

using adapters::Accessor;
using adapters::Shape;

AdaptedDescriber::AdaptedDescriber(TypeDescriber& types, const clang::CXXRecordDecl& type, const AdapterMatch& match,
                                   diag::Sink& sink)
    : types_(types), type_(type), match_(match), adapter_(*match.adapter), sink_(sink), check_(types.sema(), type) {}

bool AdaptedDescriber::describe(model::TypeModel& into) {
    const auto name = nameOf(type_);
    const clang::ASTRecordLayout& layout = types_.context().getASTRecordLayout(&type_);
    const auto finish = [&](auto result, auto& list) {
        result.cpp = name->cpp;
        result.initial = initial(result.cpp);
        result.constructors = constructors(result.cpp);
        if (!sound_) return;
        result.name = name->registry;
        result.size = layout.getSize().getQuantity();
        result.align = layout.getAlignment().getQuantity();
        const DocComment doc = types_.docOf(type_);
        result.doc = adapter_.doc.empty() ? doc.text : adapter_.doc;
        if constexpr (std::is_same_v<decltype(result), model::Struct>)
            result.message = doc.ros;
        else
            types_.refuseMessage(doc, type_.getLocation(), "class '" + shownName(type_) + "'");
        result.where = types_.locate(type_.getLocation());
        result.homes = types_.homesOf(type_);
        list.push_back(result);
        addNames(into, name->registry);
    };
    if (adapter_.shape == Shape::Struct)
        finish(describeStruct(), into.structs);
    else
        finish(describeElements(), into.adapted);
    return sound_;
}

/// The adapter's name comes before the user's aliases.
void AdaptedDescriber::addNames(model::TypeModel& into, const std::string& registry) {
    const diag::Location where = types_.locate(type_.getLocation());
    into.aliases.push_back(
        {adapter_.name.empty() ? registry : adapters::expanded(adapter_.name, match_.names), registry, where});
    if (!adapter_.alias.empty())
        into.aliases.push_back({adapters::expanded(adapter_.alias, match_.names), registry, where});
}

model::Struct AdaptedDescriber::describeStruct() {
    model::Struct result;
    for (const adapters::Member& member : adapter_.members) {
        subject_ = "member '" + member.name + "'";
        const Part found = part(member.get, member.set);
        if (!found.use) continue;
        model::Field field;
        field.name = member.name;
        field.also = member.also;
        field.type = *found.use;
        field.access = found.access;
        field.doc = member.doc;
        field.unit = member.unit.empty() ? found.use->unit : member.unit;
        field.range = member.range;
        field.where = types_.locate(type_.getLocation());
        result.fields.push_back(field);
    }
    return result;
}

model::Adapted AdaptedDescriber::describeElements() {
    model::Adapted result;
    subject_ = "the element";
    const Part found = part(adapter_.element, adapter_.set);
    if (found.use) result.element = *found.use;
    result.access = found.access;
    bool isNumber = false;
    if (adapter_.shape == Shape::Sequence) {
        result.count = size(adapter_.size, isNumber);
        if (isNumber && adapter_.resize.given()) fail(adapter_.resize, "TK073", "the size never changes");
    } else {
        bool hasRows = false;
        result.count = size(adapter_.rows, hasRows);
        result.columns = size(adapter_.columns, isNumber);
        if (found.use) {
            const std::string& element = found.use->cpp;
            const bool isFixed = isNumber;
            result.row = {
                model::TypeKind::Sequence,
                isFixed ? "std::array<" + element + ", " + result.columns + ">" : "std::vector<" + element + ">",
                isFixed ? "/std/array<" + found.use->name + "," + result.columns + ">"
                        : "/std/vector<" + found.use->name + ">",
                {*found.use},
                ""};
        }
        if (isNumber && hasRows && adapter_.resize.given()) fail(adapter_.resize, "TK073", "the size never changes");
    }
    if (adapter_.resize.given()) result.resize = resize(adapter_.resize);
    return result;
}

AdaptedDescriber::Part AdaptedDescriber::part(const Accessor& get, const Accessor& set) {
    Part result;
    const Accessor from = bound(get, match_.cpp);
    const Accessed read = check_.access(from, /*isConst=*/true);
    if (read.expression == nullptr) {
        fail(get, "TK072", "the compiler says: " + read.error);
        return result;
    }
    const auto use = classify(get, read.valueType());
    if (!use) return result;
    result.access.get = cppOf(from);
    if (isSettable(get, set, read.valueType(), result)) result.use = use;
    return result;
}

bool AdaptedDescriber::isSettable(const Accessor& get, const Accessor& set, clang::QualType value, Part& part) {
    const Accessor& meant = set.given() ? set : get;
    const Accessor to = bound(meant, match_.cpp);
    const Accessed target = check_.access(to, /*isConst=*/false, value);
    if (target.expression == nullptr) {
        fail(meant, "TK072", "the compiler says: " + target.error);
        return false;
    }
    part.access.set = cppOf(to);
    part.access.isAssigned = !to.uses("value");
    if (!part.access.isAssigned) return true;
    part.access.hasAddress = target.isPlace() && types_.context().hasSameType(target.valueType(), value);
    const std::string error = check_.assign(target, value);
    if (error.empty()) return true;
    fail(meant, "TK073", "it cannot be assigned to: " + error)
        .hint("say how it is changed: set=\"setX(value)\", or an accessor that returns a reference");
    return false;
}

std::optional<model::TypeUse> AdaptedDescriber::classify(const Accessor& accessor, clang::QualType type) {
    const std::string shown = shownName(type, types_.context());
    if (type->isArrayType() || type->isVoidType()) {
        fail(accessor, "TK073", "its type is '" + shown + "', expected a value").hint("reach each element by itself");
        return std::nullopt;
    }
    const Classified found = classifyValue(type, types_.context());
    if (!found.use) {
        Rejection rejection;
        rejection.reason = found.reason;
        rejection.subject = "it";
        rejection.type = shownName(found.culprit, types_.context());
        fail(accessor, "TK073", sentence(rejection));
        return std::nullopt;
    }
    for (const clang::TagDecl* tag : found.users) {
        complete(*tag, types_.sema(), type_.getLocation());
        const clang::TagDecl* definition = tag->getDefinition();
        if (definition == nullptr || isHidden(*definition)) {
            fail(accessor, "TK073",
                 "its type '" + shown + "' is " + (definition == nullptr ? "never defined" : "not public"));
            return std::nullopt;
        }
        const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(definition);
        const TypeFate& fate =
            record != nullptr ? types_.describe(*record) : types_.describe(llvm::cast<clang::EnumDecl>(*definition));
        if (fate.usable && fate.isSample) continue;
        diag::Diagnostic& error = fail(accessor, "TK073", "its type '" + shown + "' cannot be described");
        for (const Rejection& cause : fate.rejections) error.note(types_.locate(cause.at), sentence(cause));
        return std::nullopt;
    }
    return found.use;
}

std::string AdaptedDescriber::size(const Accessor& accessor, bool& isNumber) {
    subject_ = "the size";
    const Accessor from = bound(accessor, match_.cpp);
    isNumber = !from.number.empty();
    if (isNumber) {
        const bool isDigits = from.number.find_first_not_of("0123456789") == std::string::npos;
        if (!isDigits || from.number.size() > 9 || std::stoul(from.number) == 0)
            fail(accessor, "TK073", "it is '" + from.number + "' here, expected a positive number");
        return from.number;
    }
    const Accessed read = check_.access(from, /*isConst=*/true);
    if (read.expression == nullptr) {
        fail(accessor, "TK072", "the compiler says: " + read.error);
    } else if (!read.expression->getType()->isIntegerType() || read.expression->getType()->isBooleanType()) {
        fail(accessor, "TK073",
             "its type is '" + shownName(read.valueType(), types_.context()) + "', expected an integer");
    }
    return cppOf(from);
}

std::string AdaptedDescriber::resize(const Accessor& accessor) {
    subject_ = "'resize'";
    const Accessor to = bound(accessor, match_.cpp);
    const Accessed called = check_.access(to, /*isConst=*/false);
    if (called.expression == nullptr) fail(accessor, "TK072", "the compiler says: " + called.error);
    return cppOf(to);
}

/// Fields and virtual functions do not matter: the author of an adapter declares the class to be a value.
const TypeFate& TypeDescriber::describeAdapted(const clang::CXXRecordDecl& type, const AdapterMatch& match,
                                               TypeFate& fate) {
    std::vector<Rejection> found = checkType(type);
    if (!found.empty() && found.front().reason == Reason::Polymorphic && !type.isAbstract()) found.clear();
    Nature nature;
    if (found.empty()) found = checkSpecialMembers(type, sema_, nature);
    settle(type, found, false, fate);
    if (fate.usable) fate.usable = AdaptedDescriber(*this, type, match, sink_).describe(into_);
    return fate;
}

diag::Diagnostic& AdaptedDescriber::fail(const Accessor& accessor, const char* code, const std::string& what) {
    sound_ = false;
    return sink_
        .error(accessor.where, code,
               subject_ + " of the adapter for '" + shownName(type_) + "', '" + accessor.text + "': " + what)
        .note(types_.locate(type_.getLocation()), "the class is here");
}

}  // namespace oroforge::cxx
