// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "find_components.hpp"

#include <algorithm>

#include <clang/base/parse_files.hpp>
#include <clang/types/cpp_type_text.hpp>

#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;

/// Finds the class that a function makes, and a text in it.
class BodyReader : public clang::RecursiveASTVisitor<BodyReader> {
public:
    const clang::CXXRecordDecl* made = nullptr;
    std::string text;
    bool global = false;  ///< it uses GlobalService
    bool VisitTypeLoc(clang::TypeLoc type) { return take(type.getType()->getAsCXXRecordDecl()); }
    bool VisitDeclRefExpr(clang::DeclRefExpr* one) {
        const auto* method = dyn_cast<clang::CXXMethodDecl>(one->getDecl());
        return method == nullptr || take(method->getParent());
    }
    bool VisitCXXNewExpr(clang::CXXNewExpr* expression) {
        made = expression->getAllocatedType()->getAsCXXRecordDecl();
        return true;
    }
    bool VisitStringLiteral(clang::StringLiteral* literal) {
        text = literal->getString().str();
        return true;
    }

private:
    bool take(const clang::CXXRecordDecl* type) {
        global = global || (type != nullptr && toolchainName(*type) == "GlobalService");
        return true;
    }
};

BodyReader read(const clang::FunctionDecl& function) {
    BodyReader reader;
    reader.TraverseStmt(function.getBody());
    return reader;
}

/// True if code other than derived classes can make an object.
bool canBeMade(const clang::CXXRecordDecl& type) {
    if (type.isAbstract() || type.isDependentType()) return false;
    const auto isOpen = [](const clang::CXXConstructorDecl* one) {
        return one->getAccess() == clang::AS_public && !one->isCopyOrMoveConstructor() && !one->isDeleted();
    };
    const bool inherits = std::any_of(type.decls_begin(), type.decls_end(), [](const clang::Decl* one) {
        return llvm::isa<clang::ConstructorUsingShadowDecl>(one);
    });
    return inherits || std::any_of(type.ctor_begin(), type.ctor_end(), isOpen);
}

class Finder {
public:
    Finder(clang::Sema& sema, const SourcePlaces& places, diag::Sink& remarks)
        : sema_(sema), places_(places), sources_(&sema.getSourceManager()), remarks_(remarks) {}

    FoundClasses find() {
        walk(*sema_.getASTContext().getTranslationUnitDecl());
        FoundClasses found;
        for (const clang::CXXRecordDecl* type : registered_) found.components.push_back({type, ""});
        for (const clang::CXXRecordDecl* type : defined_) {
            if (std::find(registered_.begin(), registered_.end(), type) != registered_.end()) continue;
            if (registered_.empty()) {
                found.components.push_back({type, ""});
            } else if (std::none_of(registered_.begin(), registered_.end(),
                                    [&](const auto* one) { return one->isDerivedFrom(type); })) {
                found.unregistered.push_back(type);
            }
        }
        takePlugin(found);
        return found;
    }

private:
    void walk(const clang::DeclContext& scope) {
        for (const clang::Decl* one : scope.decls()) {
            if (sources_->isInSystemHeader(sources_->getExpansionLoc(one->getLocation()))) continue;
            if (const auto* space = dyn_cast<clang::NamespaceDecl>(one)) walk(*space);
            if (const auto* block = dyn_cast<clang::LinkageSpecDecl>(one)) walk(*block);
            if (const auto* type = dyn_cast<clang::CXXRecordDecl>(one)) takeClass(*type);
            if (const auto* variable = dyn_cast<clang::VarDecl>(one)) takeLoader(*variable);
            if (const auto* function = dyn_cast<clang::FunctionDecl>(one)) takeFunction(*function);
        }
    }

    void takeClass(const clang::CXXRecordDecl& type) {
        if (!type.isThisDeclarationADefinition() || type.isImplicit()) return;
        walk(type);
        const bool listed =
            places_.isListed(*sources_, type.getLocation()) ||
            std::any_of(type.ctor_begin(), type.ctor_end(), [&](const clang::CXXConstructorDecl* one) {
                const clang::FunctionDecl* definition = nullptr;
                return one->hasBody(definition) && places_.isListed(*sources_, definition->getLocation());
            });
        if (listed && canBeMade(type) && isDerivedFrom(type, "TaskContext")) defined_.push_back(&type);
    }

    /// Handles the static object that ORO_LIST_COMPONENT_TYPE makes.
    void takeLoader(const clang::VarDecl& variable) {
        const auto* type = variable.getType()->getAsCXXRecordDecl();
        if (type == nullptr || toolchainName(*type) != "ComponentFactoryLoader") return;
        const clang::QualType component = firstArgument(variable.getType());
        // A template may not have been instantiated for this class before.
        if (!component.isNull()) (void)sema_.isCompleteType(variable.getLocation(), component);
        const auto* record = component.isNull() ? nullptr : component->getAsCXXRecordDecl();
        const auto* definition = record == nullptr ? nullptr : record->getDefinition();
        if (definition == nullptr || !isDerivedFrom(*definition, "TaskContext")) return;
        if (std::find(registered_.begin(), registered_.end(), definition) == registered_.end())
            registered_.push_back(definition);
    }

    /// Handles functions that ORO_SERVICE_NAMED_PLUGIN makes.
    void takeFunction(const clang::FunctionDecl& function) {
        if (!function.isThisDeclarationADefinition() || function.getBody() == nullptr ||
            !function.getDeclName().isIdentifier())
            return;
        if (function.getName() == "createService") service_ = read(function).made;
        if (function.getName() == "getRTTPluginName") pluginName_ = read(function).text;
        if (function.getName() == "loadRTTPlugin" && places_.isListed(*sources_, function.getLocation()))
            load_ = &function;
    }

    void takePlugin(FoundClasses& found) {
        const bool isService = service_ != nullptr && isDerivedFrom(*service_, "Service");
        if (isService) found.services.push_back({service_, pluginName_});
        if (load_ == nullptr) return;
        const diag::Location where = places_.locate(*sources_, load_->getLocation());
        if (isService) {
            if (read(*load_).global)
                remarks_.warning(where, "OC025",
                                 "this service is one for the whole process; that of a manifest is made for each "
                                 "component that loads it");
        } else if (load_->getLocation().isMacroID()) {
            remarks_.warning(
                where, "OC025",
                "a manifest has no words for what this plugin brings: a typekit or a transport written by hand");
        } else if (pluginName_.empty()) {
            remarks_.warning(where, "OC021", "the name of this plugin is not constant");
        } else {
            found.plugins.push_back({{pluginName_, where}, "", where});
        }
    }

    clang::Sema& sema_;
    const SourcePlaces& places_;
    const clang::SourceManager* sources_;
    diag::Sink& remarks_;
    std::vector<const clang::CXXRecordDecl*> defined_;
    std::vector<const clang::CXXRecordDecl*> registered_;
    const clang::CXXRecordDecl* service_ = nullptr;
    const clang::FunctionDecl* load_ = nullptr;
    std::string pluginName_;
};

/// Has the compiler make the body for a template instance, which it does only when the function is used.
void makeBody(const clang::CXXConstructorDecl& constructor, clang::Sema& sema) {
    auto& made = const_cast<clang::CXXConstructorDecl&>(constructor);
    if (made.hasBody() || !made.isTemplateInstantiation()) return;
    sema.InstantiateFunctionDefinition(made.getLocation(), &made, /*Recursive=*/true, /*DefinitionRequired=*/false);
}

bool takesOneText(const clang::CXXConstructorDecl& constructor) {
    return constructor.getNumParams() != 0 && constructor.getMinRequiredArguments() <= 1 &&
           isStdString(constructor.getParamDecl(0)->getType());
}

}  // namespace

FoundClasses findComponents(clang::Sema& sema, const SourcePlaces& places, diag::Sink& remarks) {
    return Finder(sema, places, remarks).find();
}

bool isDerivedFrom(const clang::CXXRecordDecl& type, const char* name) {
    if (toolchainName(type) == name) return true;
    const clang::CXXRecordDecl* definition = type.getDefinition();
    if (definition == nullptr) return false;
    return std::any_of(definition->bases_begin(), definition->bases_end(), [&](const clang::CXXBaseSpecifier& base) {
        const auto* one = base.getType()->getAsCXXRecordDecl();
        return one != nullptr && isDerivedFrom(*one, name);
    });
}

const clang::CXXConstructorDecl* constructorOf(const clang::CXXRecordDecl& type, clang::Sema& sema) {
    const clang::CXXConstructorDecl* first = nullptr;
    for (const clang::CXXConstructorDecl* one : type.ctors()) {
        if (one->isCopyOrMoveConstructor() || one->isDeleted()) continue;
        makeBody(*one, sema);
        if (takesOneText(*one)) return one;
        if (first == nullptr && !one->isImplicit()) first = one;
    }
    if (first != nullptr) return first;
    // "using TaskContext::TaskContext": the compiler makes the constructor only for a call.
    for (const clang::Decl* one : type.decls()) {
        const auto* shadow = dyn_cast<clang::ConstructorUsingShadowDecl>(one);
        if (shadow == nullptr) continue;
        auto* base = dyn_cast<clang::CXXConstructorDecl>(shadow->getTargetDecl());
        if (base == nullptr || !takesOneText(*base)) continue;
        clang::CXXConstructorDecl* made = sema.findInheritingConstructor(
            type.getLocation(), base, const_cast<clang::ConstructorUsingShadowDecl*>(shadow));
        if (made != nullptr && !made->hasBody()) sema.DefineInheritingConstructor(type.getLocation(), made);
        return made;
    }
    return nullptr;
}

std::string classNameOf(const clang::CXXRecordDecl& type) {
    const clang::ASTContext& context = type.getASTContext();
    if (llvm::isa<clang::ClassTemplateSpecializationDecl>(type))
        return cppTypeText(context.getTypeDeclType(&type), context);
    std::string name = type.getNameAsString();
    for (const clang::DeclContext* scope = type.getDeclContext(); scope != nullptr; scope = scope->getParent()) {
        const auto* named = dyn_cast<clang::NamedDecl>(scope);
        if (named != nullptr && !named->getName().empty()) name = named->getNameAsString() + "::" + name;
    }
    return name;
}

}  // namespace oroforge::cxx
