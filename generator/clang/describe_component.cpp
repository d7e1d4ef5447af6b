// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "describe_component.hpp"

#include <array>

#include "doc_comment.hpp"
#include "follow.hpp"
#include "parse_files.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;

/// Calls visit(class) for the class and for those of the user's that it is derived from.
template <class Visit>
void eachOwn(const clang::CXXRecordDecl& type, const Visit& visit) {
    if (isLibrary(type)) return;
    visit(type);
    for (const clang::CXXBaseSpecifier& base : type.bases()) {
        const auto* record = base.getType()->getAsCXXRecordDecl();
        if (record != nullptr && record->hasDefinition()) eachOwn(*record->getDefinition(), visit);
    }
}

model::Hooks hooksOf(const clang::CXXRecordDecl& type) {
    model::Hooks hooks = {false, false, false, false, false, false, false};
    const std::pair<const char*, bool*> known[] = {{"configureHook", &hooks.configure}, {"startHook", &hooks.start},
                                                   {"updateHook", &hooks.update},       {"stopHook", &hooks.stop},
                                                   {"cleanupHook", &hooks.cleanup},     {"errorHook", &hooks.error},
                                                   {"exceptionHook", &hooks.exception}};
    eachOwn(type, [&](const clang::CXXRecordDecl& one) {
        for (const clang::CXXMethodDecl* method : one.methods()) {
            for (const auto& [name, wanted] : known) {
                const bool isHook = method->getDeclName().isIdentifier() && method->getNumParams() == 0;
                if (isHook && method->getName() == name) *wanted = true;
            }
        }
    });
    return hooks;
}

/// "this->", "ports()->", "provides("x")->": whether the object of a call is the component itself or one of its services.
bool isOwn(const clang::Expr* object) {
    for (;;) {
        object = object->IgnoreParenImpCasts();
        if (llvm::isa<clang::CXXThisExpr>(object)) return true;
        if (const auto* call = dyn_cast<clang::CXXMemberCallExpr>(object)) {
            object = call->getImplicitObjectArgument();
        } else if (const auto* arrow = dyn_cast<clang::CXXOperatorCallExpr>(object);
                   arrow != nullptr && arrow->getOperator() == clang::OO_Arrow) {
            object = arrow->getArg(0);
        } else if (const auto* temporary = dyn_cast<clang::MaterializeTemporaryExpr>(object)) {
            object = temporary->getSubExpr();
        } else if (const auto* bound = dyn_cast<clang::CXXBindTemporaryExpr>(object)) {
            object = bound->getSubExpr();
        } else {
            return false;
        }
        if (object == nullptr) return false;
    }
}

/// Finds what functions add that are not called while the component is made.
class LateFinder : public clang::RecursiveASTVisitor<LateFinder> {
public:
    using Report = std::function<void(const clang::CXXMemberCallExpr&, const std::string&)>;
    LateFinder(const std::set<const clang::CallExpr*>& met, Report report) : met_(met), report_(std::move(report)) {}

    bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* call) {
        const clang::CXXMethodDecl* method = call->getMethodDecl();
        if (method == nullptr || !method->getDeclName().isIdentifier() || met_.count(call) != 0) return true;
        if (toolchainName(*method->getParent()).empty() || !isOwn(call->getImplicitObjectArgument())) return true;
        static const std::array<std::pair<const char*, const char*>, 12> names = {
            {{"addPort", "port"},
             {"addEventPort", "port"},
             {"addLocalPort", "port"},
             {"addLocalEventPort", "port"},
             {"addProperty", "property"},
             {"addAttribute", "attribute"},
             {"addConstant", "constant"},
             {"addOperation", "operation"},
             {"addSynchronousOperation", "operation"},
             {"addEventOperation", "operation"},
             {"addOperationCaller", "operation caller"},
             {"addService", "service"}}};
        for (const auto& [name, what] : names) {
            if (method->getName() == name) report_(*call, what);
        }
        return true;
    }

private:
    const std::set<const clang::CallExpr*>& met_;
    Report report_;
};

}  // namespace

model::Text ComponentDescriber::nameOf(const clang::CXXRecordDecl& type) const {
    return {classNameOf(type), places_.locate(sema_.getSourceManager(), type.getLocation())};
}

std::string ComponentDescriber::docOf(const clang::CXXRecordDecl& type) const {
    return docComment(sema_.getASTContext(), type).text;
}

Followed ComponentDescriber::follow(const clang::CXXRecordDecl& type) {
    Follower follower(sema_.getASTContext(), places_, remarks_);
    const clang::SourceManager& sources = sema_.getSourceManager();
    const clang::CXXConstructorDecl* constructor = constructorOf(type, sema_);
    Followed made;
    if (constructor == nullptr) {
        remarks_.warning(nameOf(type).where, "OC023",
                         "class '" + classNameOf(type) + "' has no constructor that is known, so its interface is not");
        return made;
    }
    made = follower.follow(*constructor);
    for (const clang::FunctionDecl* unseen : follower.unseen()) {
        const clang::SourceLocation at = sources.getExpansionLoc(unseen->getLocation());
        const auto file = sources.getFileEntryRefForID(sources.getFileID(at));
        if (file) incomplete_.insert(file->getName().str());
    }
    eachOwn(type, [&](const clang::CXXRecordDecl& one) {
        for (const clang::CXXMethodDecl* method : one.methods()) {
            const clang::FunctionDecl* definition = nullptr;
            if (llvm::isa<clang::CXXConstructorDecl>(method) || !method->hasBody(definition)) continue;
            LateFinder finder(follower.met(), [&](const clang::CXXMemberCallExpr& call, const std::string& what) {
                remarks_.warning(places_.locate(sources, call.getExprLoc()), "OC022",
                                 what + " is added in '" + method->getNameAsString() +
                                     "', which is not called while the component is made");
            });
            finder.TraverseStmt(definition->getBody());
        }
    });
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
    return component;
}

model::ServicePlugin ComponentDescriber::service(const FoundClass& found) {
    model::ServicePlugin service;
    service.className = nameOf(*found.type);
    service.where = service.className.where;
    Followed made = follow(*found.type);
    static_cast<model::Interface&>(service) = std::move(made.interface);
    service.name = {found.service.empty() ? made.serviceName : found.service, service.where};
    service.doc = made.doc;  // others see it; a comment on the class they do not
    return service;
}

}  // namespace oroforge::cxx
