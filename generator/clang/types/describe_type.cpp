// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "describe_type.hpp"

#include <cstring>

#include <clang/base/type_names.hpp>

#include "collect_fields.hpp"

namespace oroforge::cxx {

namespace {

constexpr std::size_t kMostNotes = 8;
constexpr const char* kAdapterAdvice =
    "; if that header is not yours, an adapter says how the class is seen (--adapters=FILE)";

model::Enumerator describeValue(const clang::EnumConstantDecl& value, const std::string& enumCpp) {
    model::Enumerator result;
    result.name = value.getNameAsString();
    result.cpp = enumCpp + "::" + result.name;
    result.value = llvm::toString(value.getInitVal(), 10);
    return result;
}

Rejection aboutInstance(const clang::CXXRecordDecl& type, const Root& root, const TypeFate& fate) {
    Rejection rejection;
    rejection.reason = fate.rejections.front().reason;
    rejection.subject = "the instance that is asked for";
    if (!root.alias.empty()) rejection.subject = "alias '" + root.alias.substr(root.alias.rfind('/') + 1) + "'";
    rejection.type = shownName(type);
    rejection.at = root.at;
    // The missing name is reported for the alias or instance itself, because no field leads to it.
    rejection.detail = fate.rejections.front().detail;
    if (rejection.reason != Reason::TemplateArgument || rejection.detail.empty()) rejection.causes = fate.rejections;
    return rejection;
}

}  // namespace

diag::Location TypeDescriber::locate(clang::SourceLocation at) const {
    return places_.locate(sema_.getSourceManager(), at);
}

DocComment TypeDescriber::docOf(const clang::Decl& declaration) const {
    DocComment doc = docComment(context(), declaration);
    attributes_.addTo(doc, declaration);
    return doc;
}

void TypeDescriber::checkName(const clang::NamedDecl& declaration, const std::string& subject) {
    const std::string name = declaration.getNameAsString();
    const bool reserved =
        name.find("__") != std::string::npos || (name.size() > 1 && name[0] == '_' && name[1] >= 'A' && name[1] <= 'Z');
    if (!reserved) return;
    sink_
        .warning(locate(declaration.getLocation()), "TK027",
                 "the name of " + subject +
                     " belongs to compilers and their libraries: it has '__' in it, or begins with "
                     "'_' and a capital")
        .hint("rename it: a macro of that name would change the header");
}

void TypeDescriber::refuseMessage(const DocComment& doc, clang::SourceLocation at, const std::string& subject) {
    if (doc.ros.empty()) return;
    sink_.error(locate(at), "TK080", subject + " cannot be a message of ROS, as '@ros' in its comment says")
        .hint("'@ros' belongs into the comment of a struct");
}

bool TypeDescriber::isOwn(const clang::TagDecl& type) const {
    return !llvm::isa<clang::ClassTemplateSpecializationDecl>(type) &&
           places_.isListed(sema_.getSourceManager(), type.getLocation());
}

const TypeFate& TypeDescriber::describe(const clang::CXXRecordDecl& type) {
    const auto [entry, isNew] = fates_.try_emplace(type.getCanonicalDecl());
    TypeFate& fate = entry->second;
    if (!isNew) return fate;
    const clang::CXXRecordDecl& definition = *type.getDefinition();
    if (const auto match = adapters_.find(definition)) return describeAdapted(definition, *match, fate);
    std::vector<Rejection> found = checkType(definition);
    FieldCollector fields(*this);
    if (found.empty()) {
        fields.collect(definition);
        found = fields.rejections();
    }
    const DocComment doc = docOf(definition);
    Nature nature;
    nature.mayBeConstant = fields.hasConstants();
    nature.isMade = !doc.make.empty();
    if (found.empty() && !fields.broken()) found = checkSpecialMembers(definition, sema_, nature);
    settle(definition, found, fields.broken(), fate);
    if (!fate.usable) return fate;
    if (isOwn(definition)) checkName(definition, "type '" + shownName(definition) + "'");
    fate.isSample = nature.assignable && !nature.isMade;

    model::Struct result;
    result.assignable = nature.assignable;
    result.make = doc.make;
    result.message = doc.ros;
    if (!doc.make.empty()) result.space = namespaceOf(definition);
    const auto name = nameOf(definition);
    const clang::ASTRecordLayout& layout = context().getASTRecordLayout(&definition);
    result.cpp = name->cpp;
    result.name = name->registry;
    result.size = layout.getSize().getQuantity();
    result.align = layout.getAlignment().getQuantity();
    result.doc = doc.text;
    result.fields = fields.fields();
    result.where = locate(definition.getLocation());
    result.homes = needs_.homesOf(definition);
    into_.structs.push_back(result);
    return fate;
}

void TypeDescriber::describe(const clang::CXXRecordDecl& type, const Root& root) {
    sema_.isCompleteType(root.at, context().getTypeDeclType(&type));
    if (type.getDefinition() == nullptr) return;  // an alias of a type whose definition nothing needs
    const TypeFate& fate = describe(type);
    // An alias may have another purpose than to ask for the type.
    if (!fate.usable && !fate.rejections.empty() && !fate.isLeftOut)
        report(aboutInstance(type, root, fate), !root.alias.empty());
    const auto name = nameOf(*type.getDefinition());
    if (fate.usable && name && !root.alias.empty())
        into_.aliases.push_back({root.alias, name->registry, locate(root.at)});
}

const TypeFate& TypeDescriber::describe(const clang::EnumDecl& type) {
    const auto [entry, isNew] = fates_.try_emplace(type.getCanonicalDecl());
    TypeFate& fate = entry->second;
    if (!isNew) return fate;
    const clang::EnumDecl& definition = *type.getDefinition();
    settle(definition, checkType(definition), false, fate);
    if (!fate.usable) return fate;

    model::Enum result;
    const auto name = nameOf(definition);
    result.cpp = name->cpp;
    result.name = name->registry;
    result.underlying = shownName(definition.getIntegerType().getCanonicalType(), context());
    result.size = context().getTypeSizeInChars(definition.getIntegerType()).getQuantity();
    const DocComment doc = docOf(definition);
    refuseMessage(doc, definition.getLocation(), "enum '" + shownName(definition) + "'");
    result.doc = doc.text;
    result.where = locate(definition.getLocation());
    result.homes = needs_.homesOf(definition);
    for (const clang::EnumConstantDecl* value : definition.enumerators()) {
        result.values.push_back(describeValue(*value, name->cpp));
        result.values.back().doc = docOf(*value).text;
        result.values.back().where = locate(value->getLocation());
    }
    into_.enums.push_back(result);
    return fate;
}

void TypeDescriber::settle(const clang::TagDecl& type, std::vector<Rejection> found, bool broken, TypeFate& fate) {
    fate.usable = found.empty() && !broken;
    fate.isLeftOut = isOwn(type) && !strict_ && isNoValue(found);
    if (!isOwn(type) || fate.isLeftOut) {
        fate.rejections = std::move(found);
        if (fate.isLeftOut) leaveOut(type, fate);
        return;
    }
    for (const Rejection& rejection : found) report(rejection);
}

void TypeDescriber::report(const Rejection& rejection, bool mayBeLeftOut) {
    const Rejection& cause = origin(rejection);
    const Rule& rule = ruleOf(cause.reason);
    std::string message = sentence(cause);
    if (!rejection.causes.empty()) {
        const std::string type = rejection.type.empty() ? "" : " has the type '" + rejection.type + "', which";
        message = rejection.subject + type + " cannot be described: " + message;
    }
    const diag::Location at = locate(rejection.at);
    diag::Diagnostic& diagnostic =
        mayBeLeftOut ? sink_.warning(at, rule.code, message + "; it is left out") : sink_.error(at, rule.code, message);
    const diag::Location written = places_.locateWritten(sema_.getSourceManager(), rejection.at);
    if (written.line != 0 && written != at) diagnostic.note(written, "written here, and put there by a macro");
    addCauses(rejection, diagnostic);
    if (std::strlen(rule.advice) == 0) return;
    const bool isElsewhere = !places_.isListed(sema_.getSourceManager(), cause.at);
    diagnostic.hint(std::string(rule.advice) + (isElsewhere && rule.isMendedByAdapter ? kAdapterAdvice : ""));
}

void TypeDescriber::addCauses(const Rejection& rejection, diag::Diagnostic& to) const {
    for (const Rejection& cause : rejection.causes) {
        if (to.notes.size() == kMostNotes) {
            to.note({}, "and more: they are reported when these are corrected");
            return;
        }
        if (to.notes.size() > kMostNotes) return;
        const std::string type = cause.type.empty() ? "" : " of type '" + cause.type + "'";
        to.note(locate(cause.at), cause.causes.empty() ? sentence(cause) : "through " + cause.subject + type);
        addCauses(cause, to);
    }
}

}  // namespace oroforge::cxx
