// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "side_notes.hpp"

#include <set>

#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

namespace {

/// Returns the innermost typedef with a plain name, which tells the width: "int64_t" for `std::int64_t`.
std::string sizeName(clang::QualType type) {
    std::string last;
    for (const auto* alias = type->getAs<clang::TypedefType>(); alias != nullptr;
         alias = alias->desugar()->getAs<clang::TypedefType>()) {
        const std::string name = alias->getDecl()->getNameAsString();
        if (name.rfind("__", 0) != 0) last = name;
    }
    return last;
}

bool hasDigits(const std::string& name) { return name.find_first_of("0123456789") != std::string::npos; }

std::string aboutNumber(clang::QualType type) {
    const auto* builtin = type->getAs<clang::BuiltinType>();
    if (builtin == nullptr) return "";
    switch (builtin->getKind()) {
        case clang::BuiltinType::WChar_S:
        case clang::BuiltinType::WChar_U:
            return "is 'wchar_t', which has 16 or 32 bits, as the system likes; char32_t has 32 everywhere";
        case clang::BuiltinType::LongDouble: return "is 'long double', which has other digits on other machines";
        case clang::BuiltinType::Long:
        case clang::BuiltinType::ULong: {
            const std::string name = sizeName(type);
            if (hasDigits(name)) return "";
            const bool isSigned = builtin->getKind() == clang::BuiltinType::Long;
            return "is '" + (name.empty() ? (isSigned ? "long" : "unsigned long") : name) +
                   "', which has 32 bits on some machines; std::" + (isSigned ? "" : "u") + "int64_t has 64 everywhere";
        }
        default: return "";
    }
}

std::string aboutType(clang::QualType type) {
    if (const auto* array = type->getAsArrayTypeUnsafe()) return aboutType(array->getElementType());
    if (const std::string number = aboutNumber(type); !number.empty()) return number;
    const auto* record = type->getAsCXXRecordDecl();
    const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
    if (record != nullptr && isStandard(*record) && record->getName() == "steady_clock")
        return "is a time of std::chrono::steady_clock, which counts from another moment on each machine";
    if (record != nullptr && isStandard(*record) && record->getName() == "polymorphic_allocator")
        return "has an allocator that copies do not take over: they use the default memory resource";
    if (instance == nullptr || !isStandard(*instance) || instance->getName() == "ratio") return "";
    // Uses arguments as written: the type itself has std::vector<unsigned long> for std::vector<std::size_t>.
    if (const auto* written = type->getAs<clang::TemplateSpecializationType>();
        written != nullptr && !written->isTypeAlias()) {
        for (const clang::TemplateArgument& argument : written->template_arguments()) {
            if (argument.getKind() != clang::TemplateArgument::Type) continue;
            if (const std::string about = aboutType(argument.getAsType()); !about.empty()) return about;
        }
        if (instance->getName() != "time_point") return "";
    }
    for (const clang::TemplateArgument& argument : instance->getTemplateArgs().asArray()) {
        const bool isClass =
            argument.getKind() == clang::TemplateArgument::Type && argument.getAsType()->isRecordType();
        if (!isClass) continue;
        if (const std::string about = aboutType(argument.getAsType()); !about.empty()) return about;
    }
    return "";
}

class TemplateWalk {
public:
    TemplateWalk(const clang::SourceManager& sources, const SourcePlaces& places, const model::TypeModel& described)
        : sources_(sources), places_(places) {
        for (const model::Struct& type : described.structs) described_.insert(type.cpp);
    }

    void walk(const clang::DeclContext& scope) {
        for (const clang::Decl* declaration : scope.decls()) {
            if (llvm::isa<clang::NamespaceDecl, clang::LinkageSpecDecl>(declaration))
                walk(*llvm::cast<clang::DeclContext>(declaration));
            if (const auto* pattern = llvm::dyn_cast<clang::ClassTemplateDecl>(declaration)) visit(*pattern);
            if (const auto* own = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(declaration)) visit(*own);
        }
    }
    std::vector<diag::Note> notes;

private:
    void visit(const clang::ClassTemplateDecl& pattern) {
        const bool isHere = pattern.isThisDeclarationADefinition() && places_.isListed(sources_, pattern.getLocation());
        if (!isHere || !pattern.specializations().empty()) return;
        const std::string name = pattern.getQualifiedNameAsString();
        notes.push_back({places_.locate(sources_, pattern.getLocation()),
                         "nothing uses the template '" + name + "', so no instance is described; 'template struct " +
                             pattern.getNameAsString() + "<…>;' or an alias asks for one"});
    }

    void visit(const clang::ClassTemplateSpecializationDecl& own) {
        const bool isWhole = own.getSpecializationKind() == clang::TSK_ExplicitSpecialization &&
                             !llvm::isa<clang::ClassTemplatePartialSpecializationDecl>(own);
        const auto name = nameOf(own);
        if (!isWhole || !name || !own.isThisDeclarationADefinition() || described_.count(name->cpp) != 0) return;
        if (!places_.isListed(sources_, own.getLocation())) return;
        notes.push_back(
            {places_.locate(sources_, own.getLocation()),
             "nothing uses the specialisation '" + shownName(own) + "', so it is not described; an alias asks for it"});
    }

    const clang::SourceManager& sources_;
    const SourcePlaces& places_;
    std::set<std::string> described_;
};

}  // namespace

std::string portabilityOf(const clang::FieldDecl& field) {
    const std::string about = aboutType(field.getType());
    return about.empty() ? "" : "field '" + field.getNameAsString() + "' " + about;
}

std::vector<diag::Note> unusedTemplates(const clang::ASTContext& context, const SourcePlaces& places,
                                        const model::TypeModel& described) {
    TemplateWalk all(context.getSourceManager(), places, described);
    all.walk(*context.getTranslationUnitDecl());
    return all.notes;
}

}  // namespace oroforge::cxx
