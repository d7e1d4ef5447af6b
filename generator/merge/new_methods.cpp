// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/new_methods.hpp>

#include <algorithm>

#include <merge/text_places.hpp>
#include <model/names.hpp>

namespace oroforge::merge {

namespace {

using model::Access;
using model::FunctionKind;
using model::UserFunction;

Access accessAtEnd(const model::UserClass& type) {
    if (!type.labels.empty()) return type.labels.back().access;
    return type.isStruct ? Access::Public : Access::Private;
}

const char* labelText(Access access) {
    return access == Access::Public ? "public:" : access == Access::Protected ? "protected:" : "private:";
}

}  // namespace

/// Returns the operations, or hooks, before it in the manifest, the nearest first.
std::vector<const WantedMethod*> NewMethods::methodsBefore(const WantedMethod& method) const {
    std::vector<const WantedMethod*> result;
    for (const WantedMethod& one : wanted_.methods) {
        if (one.name == method.name) break;
        if (one.isHook == method.isHook) result.insert(result.begin(), &one);
    }
    return result;
}

/// Returns the functions that it may follow, the best first.
std::vector<const UserFunction*> NewMethods::ranked(const WantedMethod& method, bool inClass) const {
    std::vector<const UserFunction*> result;
    const auto usable = [&](const UserFunction& function) {
        return function.inClass == inClass && !function.isMacro && (inClass || function.isDefinition) &&
               function.whole.end > function.whole.begin;
    };
    const auto addLast = [&](const auto& test) {
        // Finds the last definition in the last file: the list is sorted by place.
        for (auto it = type_.functions.rbegin(); it != type_.functions.rend(); ++it)
            if (usable(*it) && test(*it)) result.push_back(&*it);
    };
    const auto addNamed = [&](const std::string& name) {
        addLast([&](const UserFunction& one) { return one.name == name; });
    };
    for (const WantedMethod* one : methodsBefore(method)) addNamed(one->name);
    bool isBehind = false;
    for (const WantedMethod& one : wanted_.methods) {
        isBehind = isBehind || one.name == method.name;
        if (isBehind && method.isHook) addNamed(one.name);
    }
    if (inClass && method.isHook) return result;
    if (!inClass && method.isHook) addLast([](const UserFunction& one) { return one.kind == FunctionKind::Method; });
    const auto isPublic = [&](const UserFunction& one) { return !inClass || one.access == Access::Public; };
    addLast([&](const UserFunction& one) { return one.kind != FunctionKind::Method && isPublic(one); });
    addLast([&](const UserFunction& one) { return isPublic(one); });
    return result;
}

Place NewMethods::placeOf(const WantedMethod& method, bool inClass) {
    const std::map<std::string, Place>& added = inClass ? declared_ : defined_;
    // The nearest one before it may have just been added.
    for (const WantedMethod* before : methodsBefore(method)) {
        const auto found = added.find(before->name);
        if (found != added.end()) return found->second;
        const auto stands = [&](const UserFunction& one) { return one.name == before->name && one.inClass == inClass; };
        if (std::any_of(type_.functions.begin(), type_.functions.end(), stands)) break;
    }
    std::vector<Neighbour> neighbours;
    for (const UserFunction* one : ranked(method, inClass)) neighbours.push_back(neighbour(*one));
    return placeBehind(neighbours, type_, input_.code);
}

std::string NewMethods::labelFor(Access wanted, const std::string& text, const std::string& lineEnd) {
    const bool same = endAccess_.value_or(accessAtEnd(type_)) == wanted;
    endAccess_ = wanted;
    if (same) return {};
    const std::size_t like = type_.labels.empty() ? type_.whole.begin : type_.labels.back().span.begin;
    return indentAt(text, like) + labelText(wanted) + lineEnd;
}

void NewMethods::addAtEnd(const WantedMethod& method, bool overrides, bool isInline) {
    const std::string& text = input_.code.texts.at(type_.file);
    const MethodStyle style = declarationStyle(text, type_, nullptr);
    const std::string label = labelFor(method.isHook ? Access::Protected : Access::Public, text, style.lineEnd);
    const std::string lines =
        label + (isInline ? inlineText(style, method, overrides) : declarationText(style, method, overrides));
    const bool closesAlone = isFirstInLine(text, type_.body.end);
    const std::size_t at = closesAlone ? lineBegin(text, type_.body.end) : type_.body.end;
    const bool isEmpty = isBlank(cut(text, type_.body));
    const bool blankLine = !isEmpty && (!label.empty() || isInline) && !blankAbove(text, at);
    // If the class is in one line, the new lines and its brace get lines of their own.
    into_.edits.insert(type_.file, at,
                       (closesAlone ? "" : style.lineEnd) + std::string(blankLine ? style.lineEnd : "") + lines);
    declared_[method.name] = {type_.file, at, nullptr, true};
}

void NewMethods::define(const WantedMethod& method, const Place& place) {
    const std::string& text = input_.code.texts.at(place.file);
    const UserFunction& near = *place.near;
    const MethodStyle style = definitionStyle(text, type_, place.file, &near);
    const std::string home = model::namespaceOf(type_.name);
    const bool trailing = near.space != home && needsNamespace(method.signature.returns, home);
    const std::string qualifier = cut(text, {near.qualifier.begin, near.nameSpan.begin});
    insertLines(into_.edits, text, place.file, place.at, definitionText(style, method, qualifier, trailing),
                style.lineEnd, true);
    defined_[method.name] = place;
    into_.changes.push_back(place.file + ": " + toText(method.signature, method.name));
}

void NewMethods::add(const WantedMethod& method) {
    const Place definition = placeOf(method, false);
    const bool isInline = !definition.known;
    const Place declaration = placeOf(method, true);
    const std::string& text = input_.code.texts.at(type_.file);
    into_.changes.push_back(type_.file + ": " + toText(method.signature, method.name));
    if (!declaration.known || declaration.near == nullptr) {
        addAtEnd(method, overrides(method), isInline);
    } else {
        const MethodStyle style = declarationStyle(text, type_, declaration.near);
        const bool blankLine = isInline || style.blankLine || !method.comment.empty();
        insertLines(
            into_.edits, text, type_.file, declaration.at,
            isInline ? inlineText(style, method, overrides(method)) : declarationText(style, method, overrides(method)),
            style.lineEnd, blankLine);
        declared_[method.name] = declaration;
    }
    if (!isInline) define(method, definition);
}

}  // namespace oroforge::merge
