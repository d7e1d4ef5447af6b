// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "describe_component.hpp"

#include <clang/base/parse_files.hpp>
#include <clang/types/doc_comment.hpp>
#include <model/names.hpp>

#include "follow.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

model::Hooks hooksOf(const clang::CXXRecordDecl& type) {
    model::Hooks hooks = {false, false, false, false, false, false, false};
    eachOwn(type, [&](const clang::CXXRecordDecl& one) {
        for (const clang::CXXMethodDecl* method : one.methods()) {
            if (!method->getDeclName().isIdentifier() || method->getNumParams() != 0) continue;
            for (const model::Hook& hook : model::kHooks)
                if (method->getName() == model::methodName(hook)) hooks.*hook.wanted = true;
        }
    });
    return hooks;
}

}  // namespace

model::Text ComponentDescriber::nameOf(const clang::CXXRecordDecl& type) const {
    return {classNameOf(type), places_.locate(sema_.getSourceManager(), type.getLocation())};
}

std::string ComponentDescriber::docOf(const clang::CXXRecordDecl& type) const {
    return docComment(sema_.getASTContext(), type).text;
}

Followed ComponentDescriber::follow(const clang::CXXRecordDecl& type) {
    const clang::SourceManager& sources = sema_.getSourceManager();
    const clang::CXXConstructorDecl* constructor = constructorOf(type, sema_);
    Followed made;
    made.hasMore = true;
    eachOwn(type, [&](const clang::CXXRecordDecl& one) { typekit_.addComponent(one); });
    if (constructor == nullptr) {
        remarks_.warning(nameOf(type).where, "OC023",
                         "class '" + classNameOf(type) + "' has no constructor that is known, so its interface is not");
        return made;
    }
    made = cxx::follow(*constructor, places_, remarks_);
    for (const clang::QualType& use : made.uses) typekit_.addUse(use);
    for (const clang::FunctionDecl* unseen : made.unseen) {
        const clang::SourceLocation at = sources.getExpansionLoc(unseen->getLocation());
        const auto file = sources.getFileEntryRefForID(sources.getFileID(at));
        if (file) incomplete_.insert(file->getName().str());
    }
    return made;
}

model::Component ComponentDescriber::component(const clang::CXXRecordDecl& type) {
    model::Component component;
    component.className = nameOf(type);
    component.where = component.className.where;
    component.doc = docOf(type);
    component.hooks = hooksOf(type);
    Followed made = follow(type);
    static_cast<model::Interface&>(component) = std::move(made.interface);
    component.required = std::move(made.required);
    component.activity = std::move(made.activity);
    component.initial = made.initial;
    component.dynamic = made.hasMore;
    return component;
}

model::ServicePlugin ComponentDescriber::service(const FoundClass& found) {
    model::ServicePlugin service;
    service.className = nameOf(*found.type);
    service.where = service.className.where;
    Followed made = follow(*found.type);
    static_cast<model::Interface&>(service) = std::move(made.interface);
    service.name = {found.service.empty() ? made.serviceName : found.service, service.where};
    service.doc = made.doc;  // others see this text, but not a comment on the class
    return service;
}

}  // namespace oroforge::cxx
