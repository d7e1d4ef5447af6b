// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cpp_type_text.hpp"

#include <array>

#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;

/// True for default arguments of the standard library's containers.
bool isDefaultOfLibrary(const clang::TemplateArgument& argument) {
    if (argument.getKind() != clang::TemplateArgument::Type) return false;
    const clang::CXXRecordDecl* type = argument.getAsType()->getAsCXXRecordDecl();
    if (type == nullptr) return false;
    static const std::array names = {"allocator", "char_traits", "less", "equal_to", "hash", "default_delete"};
    return std::any_of(names.begin(), names.end(), [&](const char* name) { return isStandard(*type, name); });
}

class Printer {
public:
    explicit Printer(const clang::ASTContext& context) : context_(context) {}

    std::string text(clang::QualType type) const {
        const clang::Qualifiers own = type.getLocalQualifiers();
        const std::string bare = unqualified(type.getTypePtr());
        return own.hasConst() ? "const " + bare : bare;
    }

private:
    std::string unqualified(const clang::Type* type) const {
        if (const auto* pointer = dyn_cast<clang::PointerType>(type)) return text(pointer->getPointeeType()) + "*";
        if (const auto* left = dyn_cast<clang::LValueReferenceType>(type))
            return text(left->getPointeeTypeAsWritten()) + "&";
        if (const auto* right = dyn_cast<clang::RValueReferenceType>(type))
            return text(right->getPointeeTypeAsWritten()) + "&&";
        if (const auto* alias = dyn_cast<clang::TypedefType>(type)) {
            if (hasOwnName(*alias->getDecl())) return alias->getDecl()->getQualifiedNameAsString();
        }
        if (const auto* used = dyn_cast<clang::UsingType>(type)) return usedName(*used);
        if (const auto* instance = dyn_cast<clang::TemplateSpecializationType>(type)) {
            if (const auto* name = instance->getAsCXXRecordDecl(); name != nullptr && !instance->isTypeAlias())
                return named(*name, instance->template_arguments());
        }
        if (const auto* builtin = dyn_cast<clang::BuiltinType>(type)) {
            const auto name = nameOf(*builtin, context_);
            return name ? name->cpp : shownName(clang::QualType(type, 0), context_);
        }
        if (const auto* tag = dyn_cast<clang::TagType>(type)) return ofTag(*tag->getDecl());
        const clang::QualType simpler = type->getLocallyUnqualifiedSingleStepDesugaredType();
        if (simpler.getTypePtr() != type) return text(simpler);
        return shownName(clang::QualType(type, 0), context_);
    }

    /// Names within template instances depend on arguments, and "__" marks names of the library itself.
    static bool hasOwnName(const clang::TypedefNameDecl& alias) {
        for (const clang::DeclContext* scope = alias.getDeclContext(); scope != nullptr; scope = scope->getParent()) {
            if (scope->isFunctionOrMethod() || llvm::isa<clang::ClassTemplateSpecializationDecl>(scope)) return false;
            const auto* space = dyn_cast<clang::NamespaceDecl>(scope);
            if (space != nullptr && space->getName().starts_with("__")) return false;
        }
        return !alias.getName().starts_with("__");
    }

    /// "std::uint8_t" is declared elsewhere, and known in std through a using-declaration.
    std::string usedName(const clang::UsingType& used) const {
        const clang::UsingShadowDecl* shadow = used.getFoundDecl();
        const std::string space =
            shadow->getDeclContext()->isTranslationUnit() ? "" : shadow->getQualifiedNameAsString();
        return space.empty() ? text(used.getUnderlyingType()) : space;
    }

    std::string ofTag(const clang::TagDecl& tag) const {
        if (const auto* instance = dyn_cast<clang::ClassTemplateSpecializationDecl>(&tag))
            return named(tag, instance->getTemplateArgs().asArray());
        return scoped(tag);
    }

    std::string scoped(const clang::TagDecl& tag) const {
        const auto name = nameOf(tag);
        if (!name) return shownName(tag);
        return name->cpp.rfind("::", 0) == 0 ? name->cpp.substr(2) : name->cpp;
    }

    std::string named(const clang::TagDecl& tag, llvm::ArrayRef<clang::TemplateArgument> arguments) const {
        std::string full = scoped(tag);
        const std::string bare = full.substr(0, full.find('<'));
        while (isStandard(tag) && !arguments.empty() && isDefaultOfLibrary(arguments.back()))
            arguments = arguments.drop_back();
        std::string list;
        if (!addAll(arguments, list)) return full;
        return bare == "std::basic_string" && list == "char" ? "std::string" : bare + "<" + list + ">";
    }

    bool addAll(llvm::ArrayRef<clang::TemplateArgument> arguments, std::string& list) const {
        for (const clang::TemplateArgument& argument : arguments) {
            if (argument.getKind() == clang::TemplateArgument::Pack) {
                if (!addAll(argument.getPackAsArray(), list)) return false;
                continue;
            }
            list += (list.empty() ? "" : ", ") + ofArgument(argument);
        }
        return true;
    }

    std::string ofArgument(const clang::TemplateArgument& argument) const {
        if (argument.getKind() == clang::TemplateArgument::Type) return text(argument.getAsType());
        clang::PrintingPolicy policy(context_.getLangOpts());
        std::string result;
        llvm::raw_string_ostream out(result);
        argument.print(policy, out, /*IncludeType=*/false);
        return result;
    }

    const clang::ASTContext& context_;
};

}  // namespace

std::string cppTypeText(clang::QualType type, const clang::ASTContext& context) { return Printer(context).text(type); }

clang::QualType firstArgument(clang::QualType type) {
    type = type.getNonReferenceType();
    const auto* written = type->getAs<clang::TemplateSpecializationType>();
    if (written != nullptr && !written->isTypeAlias() && !written->template_arguments().empty()) {
        const clang::TemplateArgument& first = written->template_arguments().front();
        if (first.getKind() == clang::TemplateArgument::Type) return first.getAsType();
    }
    const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
    if (instance == nullptr || instance->getTemplateArgs().size() == 0) return {};
    const clang::TemplateArgument& first = instance->getTemplateArgs()[0];
    return first.getKind() == clang::TemplateArgument::Type ? first.getAsType() : clang::QualType();
}

}  // namespace oroforge::cxx
