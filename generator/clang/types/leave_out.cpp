// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/type_names.hpp>

#include "classify.hpp"
#include "describe_type.hpp"

namespace oroforge::cxx {

namespace {

/// Returns "port", "property" or "attribute" if the field has such a class of the runtime; otherwise empty.
std::string roleOf(const clang::ClassTemplateSpecializationDecl& type) {
    const std::string name = type.getQualifiedNameAsString();
    if (name == "RTT::InputPort" || name == "RTT::OutputPort") return "port";
    if (name == "RTT::Property") return "property";
    return name == "RTT::Attribute" || name == "RTT::Constant" ? "attribute" : "";
}

/// Finds the first cause for the class not being a value; its fields may have other faults.
const Rejection* findNoValue(const std::vector<Rejection>& rejections) {
    for (const Rejection& one : rejections) {
        if (!isNoValue({one})) continue;
        return one.causes.empty() ? &one : findNoValue(one.causes);
    }
    return nullptr;
}

}  // namespace

void TypeDescriber::leaveOut(const clang::TagDecl& type, const TypeFate& fate) {
    const Rejection& first = *findNoValue(fate.rejections);
    const std::string subject = "type '" + shownName(type) + "'";
    diag::Diagnostic& warning = sink_.warning(
        locate(type.getLocation()), ruleOf(first.reason).code,
        first.subject == subject ? sentence(first) + "; it is left out" : subject + " is left out: " + sentence(first));
    Rejection whole;
    whole.causes = fate.rejections;
    if (fate.rejections.size() > 1 || first.at != type.getLocation()) addCauses(whole, warning);
    warning.hint("[[oro::skip]] before its name says that this is meant; with --strict it is an error");
    if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(&type)) checkPorts(*record);
}

/// A component is not a value, but its ports request types.
void TypeDescriber::checkPorts(const clang::CXXRecordDecl& type) {
    for (const clang::FieldDecl* field : type.fields()) {
        const auto* wrapper =
            llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(field->getType()->getAsCXXRecordDecl());
        const std::string role = wrapper == nullptr ? "" : roleOf(*wrapper);
        if (role.empty() || wrapper->getTemplateArgs()[0].getKind() != clang::TemplateArgument::Type) continue;
        const clang::QualType held = wrapper->getTemplateArgs()[0].getAsType();
        for (const clang::TagDecl* user : classifyValue(held, context()).users) {
            const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(user);
            if (record == nullptr || record->getDefinition() == nullptr || !isOwn(*record)) continue;
            const TypeFate& fate = describe(*record);
            if (!fate.isLeftOut) continue;
            Rejection rejection;
            rejection.reason = fate.rejections.front().reason;
            rejection.subject = role + " '" + field->getNameAsString() + "' of '" + shownName(type) + "'";
            rejection.type = shownName(held, context());
            rejection.at = field->getLocation();
            rejection.causes = fate.rejections;
            report(rejection);
        }
    }
}

}  // namespace oroforge::cxx
