// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "type_names.hpp"

namespace oroforge::cxx {

namespace {

using clang::BuiltinType;

/// Returns the name of the declaration, or of its typedef in C style: `typedef struct {…} T;`.
std::string ownName(const clang::TagDecl& type) {
    if (const clang::TypedefNameDecl* alias = type.getTypedefNameForAnonDecl()) return alias->getNameAsString();
    return type.getNameAsString();
}

/// Returns the field that an unnamed struct belongs to, as in `struct { int x; } place;`: the first of several.
const clang::FieldDecl* fieldOfUnnamed(const clang::TagDecl& type) {
    const auto* record = llvm::dyn_cast<clang::RecordDecl>(&type);
    const auto* owner = llvm::dyn_cast<clang::RecordDecl>(type.getDeclContext());
    if (record == nullptr || owner == nullptr || record->isAnonymousStructOrUnion() || !ownName(type).empty())
        return nullptr;
    for (const clang::FieldDecl* field : owner->fields()) {
        const clang::QualType element = type.getASTContext().getBaseElementType(field->getType());
        const clang::TagDecl* declared = element->getAsTagDecl();
        if (declared != nullptr && declared->getCanonicalDecl() == type.getCanonicalDecl()) return field;
    }
    return nullptr;
}

/// Names such a struct by its field, because it has no other name.
std::optional<TypeName> nameByField(const clang::FieldDecl& field) {
    const clang::RecordDecl* owner = field.getParent();
    while (owner->isAnonymousStructOrUnion()) owner = llvm::cast<clang::RecordDecl>(owner->getParent());
    const auto outer = nameOf(*owner);
    if (!outer || field.getName().empty()) return std::nullopt;
    const std::string own = field.getNameAsString();
    std::string cpp = "decltype(" + outer->cpp + "::" + own + ")";
    if (field.getType()->isArrayType()) cpp = "std::remove_all_extents_t<" + cpp + ">";
    if (field.getType().isConstQualified()) cpp = "std::remove_const_t<" + cpp + ">";
    return TypeName{cpp, outer->registry + "/" + own};
}

/// Returns an enumerator with that value; nothing if there is none, or if other code cannot name it.
std::optional<TypeName> nameOfEnumerator(const clang::EnumDecl& type, const llvm::APSInt& value) {
    const auto name = nameOf(type);
    const clang::EnumDecl* definition = type.getDefinition();
    if (!name || definition == nullptr) return std::nullopt;
    for (const clang::EnumConstantDecl* one : definition->enumerators()) {
        if (!llvm::APSInt::isSameValue(one->getInitVal(), value)) continue;
        const std::string own = one->getNameAsString();
        return TypeName{name->cpp + "::" + own, name->registry + "/" + own};
    }
    return std::nullopt;
}

std::optional<TypeName> nameOfArgument(const clang::TemplateArgument& argument, const clang::ASTContext& context) {
    if (argument.getKind() == clang::TemplateArgument::Integral) {
        const std::string digits = llvm::toString(argument.getAsIntegral(), 10);
        if (argument.getIntegralType()->isBooleanType()) return TypeName{digits == "0" ? "false" : "true", digits};
        if (const auto* type = argument.getIntegralType()->getAs<clang::EnumType>())
            return nameOfEnumerator(*type->getDecl(), argument.getAsIntegral());
        return TypeName{digits, digits};
    }
    if (argument.getKind() != clang::TemplateArgument::Type) return std::nullopt;
    const clang::QualType type = argument.getAsType().getCanonicalType();
    if (type.isVolatileQualified()) return std::nullopt;
    std::optional<TypeName> name;
    if (const auto* builtin = type->getAs<BuiltinType>()) name = nameOf(*builtin, context);
    if (type->isVoidType()) name = TypeName{"void", "/void"};  // as in std::allocator<void>
    if (const clang::TagDecl* tag = type->getAsTagDecl()) name = nameOf(*tag);
    if (name && type.isConstQualified()) name = TypeName{"const " + name->cpp, "const " + name->registry};
    return name;
}

bool addArguments(const clang::ClassTemplateSpecializationDecl& type, TypeName& name) {
    const auto all = argumentsOf(type);
    if (!all) return false;
    std::string cpp, registry;
    for (const TypeName& part : *all) {
        cpp += (cpp.empty() ? "" : ", ") + part.cpp;
        registry += (registry.empty() ? "" : ",") + part.registry;
    }
    name.cpp += "<" + cpp + ">";
    name.registry += "<" + registry + ">";
    return true;
}

bool addScope(const clang::DeclContext* scope, TypeName& name);

bool addPart(const clang::NamedDecl& declaration, const std::string& own, TypeName& name) {
    if (own.empty() || !addScope(declaration.getDeclContext(), name)) return false;
    name.cpp += "::" + own;
    name.registry += "/" + own;
    const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&declaration);
    return instance == nullptr || addArguments(*instance, name);
}

bool addScope(const clang::DeclContext* scope, TypeName& name) {
    scope = scope->getRedeclContext();
    if (scope->isTranslationUnit()) return true;
    if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(scope)) {
        // std::__cxx11 and the like belong to the particular library of this machine.
        if (space->isInline() && isStandard(*space) && space->getName().starts_with("_"))
            return addScope(space->getDeclContext(), name);
        return addPart(*space, space->getNameAsString(), name);
    }
    const auto* outer = llvm::dyn_cast<clang::TagDecl>(scope);
    const auto outerName = outer != nullptr ? nameOf(*outer) : std::nullopt;
    if (!outerName) return false;
    name.cpp += outerName->cpp;
    name.registry += outerName->registry;
    return true;
}

bool isWidth(const BuiltinType& type, unsigned bits, bool isSigned, const clang::ASTContext& context) {
    return context.hasSameType(clang::QualType(&type, 0), context.getIntTypeForBitwidth(bits, isSigned));
}

}  // namespace

std::optional<std::vector<TypeName>> argumentsOf(const clang::ClassTemplateSpecializationDecl& type) {
    std::vector<clang::TemplateArgument> all;
    for (const clang::TemplateArgument& argument : type.getTemplateArgs().asArray()) {
        if (argument.getKind() == clang::TemplateArgument::Pack)
            all.insert(all.end(), argument.pack_begin(), argument.pack_end());
        else
            all.push_back(argument);
    }
    std::vector<TypeName> names;
    for (const clang::TemplateArgument& argument : all) {
        const auto name = nameOfArgument(argument, type.getASTContext());
        if (!name) return std::nullopt;
        names.push_back(*name);
    }
    return names;
}

std::optional<TypeName> nameOf(const clang::TagDecl& type) {
    if (const clang::FieldDecl* field = fieldOfUnnamed(type)) return nameByField(*field);
    TypeName name;
    if (!addPart(type, ownName(type), name)) return std::nullopt;
    return name;
}

std::optional<std::string> nameOf(const clang::TypedefNameDecl& alias) {
    TypeName name;
    if (!addPart(alias, alias.getNameAsString(), name)) return std::nullopt;
    return name.registry;
}

std::optional<TypeName> nameOf(const BuiltinType& type, const clang::ASTContext& context) {
    switch (type.getKind()) {
        case BuiltinType::Bool: return TypeName{"bool", "/bool"};
        case BuiltinType::Char_S:
        case BuiltinType::Char_U: return TypeName{"char", "/char"};
        case BuiltinType::SChar: return TypeName{"signed char", "/int8_t"};
        case BuiltinType::UChar: return TypeName{"unsigned char", "/uint8_t"};
        case BuiltinType::Short: return TypeName{"short", "/int16_t"};
        case BuiltinType::UShort: return TypeName{"unsigned short", "/uint16_t"};
        case BuiltinType::Int: return TypeName{"int", "/int32_t"};
        case BuiltinType::UInt: return TypeName{"unsigned int", "/uint32_t"};
        // One of the two 64-bit types is std::int64_t; the other keeps RTT's name, because it is another C++ type.
        case BuiltinType::Long: return TypeName{"long", isWidth(type, 64, true, context) ? "/int64_t" : "/long"};
        case BuiltinType::ULong:
            return TypeName{"unsigned long", isWidth(type, 64, false, context) ? "/uint64_t" : "/ulong"};
        case BuiltinType::LongLong:
            return TypeName{"long long", isWidth(type, 64, true, context) ? "/int64_t" : "/llong"};
        case BuiltinType::ULongLong:
            return TypeName{"unsigned long long", isWidth(type, 64, false, context) ? "/uint64_t" : "/ullong"};
        case BuiltinType::Float: return TypeName{"float", "/float"};
        case BuiltinType::Double: return TypeName{"double", "/double"};
        case BuiltinType::LongDouble: return TypeName{"long double", "/long_double"};
        case BuiltinType::WChar_S:
        case BuiltinType::WChar_U: return TypeName{"wchar_t", "/wchar_t"};
        case BuiltinType::Char16: return TypeName{"char16_t", "/char16_t"};
        case BuiltinType::Char32: return TypeName{"char32_t", "/char32_t"};
        default: return std::nullopt;
    }
}

std::string namespaceOf(const clang::TagDecl& type) {
    const clang::DeclContext* scope = type.getDeclContext()->getEnclosingNamespaceContext();
    return scope->isTranslationUnit() ? "" : "::" + llvm::cast<clang::NamespaceDecl>(scope)->getQualifiedNameAsString();
}

std::string unnamedArgument(const clang::TagDecl& type) {
    const clang::ASTContext& context = type.getASTContext();
    const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&type);
    if (instance == nullptr) {  // a member of an instance, perhaps
        const auto* outer = llvm::dyn_cast<clang::TagDecl>(type.getDeclContext());
        return outer != nullptr ? unnamedArgument(*outer) : "";
    }
    clang::PrintingPolicy policy(context.getLangOpts());
    policy.AnonymousTagLocations = false;
    for (const clang::TemplateArgument& argument : instance->getTemplateArgs().asArray()) {
        const bool isPack = argument.getKind() == clang::TemplateArgument::Pack;
        for (const clang::TemplateArgument& part : isPack ? argument.getPackAsArray() : llvm::ArrayRef(argument)) {
            if (nameOfArgument(part, context)) continue;
            std::string text;
            llvm::raw_string_ostream out(text);
            part.print(policy, out, /*IncludeType=*/false);
            return text;
        }
    }
    return "";
}

std::string shownName(const clang::TagDecl& type) {
    const clang::ASTContext& context = type.getASTContext();
    return shownName(context.getTypeDeclType(&type).getCanonicalType(), context);
}

std::string shownName(clang::QualType type, const clang::ASTContext& context) {
    clang::PrintingPolicy policy(context.getLangOpts());
    policy.AnonymousTagLocations = false;  // these would contain paths of this machine
    return type.getAsString(policy);
}

llvm::StringRef outermostNamespace(const clang::Decl& declaration) {
    const clang::NamespaceDecl* outermost = nullptr;
    for (const clang::DeclContext* scope = declaration.getDeclContext(); scope != nullptr; scope = scope->getParent()) {
        if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(scope)) outermost = space;
    }
    return outermost != nullptr ? outermost->getName() : llvm::StringRef();
}

bool isStandard(const clang::Decl& declaration) { return outermostNamespace(declaration) == "std"; }

bool isStandard(const clang::CXXRecordDecl& type, const char* name) {
    return type.isInStdNamespace() && type.getName() == name;
}

}  // namespace oroforge::cxx
