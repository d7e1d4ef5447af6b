// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "field_forms.hpp"

#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

namespace {

using model::AccessKind;
using model::TypeKind;

FieldForm unsuited(const clang::FieldDecl& field) { return {reject(Reason::UnsuitedAttribute, field.getType())}; }

const clang::ClassTemplateSpecializationDecl* instanceOf(clang::QualType type, const char* name) {
    const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
    return instance != nullptr && isStandard(*instance, name) ? instance : nullptr;
}

/// Shows `char m[N]` and `std::array<char, N> m` as a string; the last byte stays 0.
FieldForm asText(const clang::FieldDecl& field, TypeDescriber& types) {
    const Classified type = classifyMember(field.getType(), types.context());
    const bool isText = type.use && type.count != 0 && type.use->cpp == "char";
    if (!isText || field.isBitField()) return unsuited(field);
    const std::string name = field.getNameAsString();
    Classified text;
    text.use = model::TypeUse{TypeKind::String, "std::string", "/std/string", {}, ""};
    return {text, {AccessKind::Text, name, name, type.count}};
}

/// Shows a union as bytes: only its author knows which member is valid.
FieldForm asBytes(const clang::FieldDecl& field, TypeDescriber& types) {
    const clang::ASTContext& context = types.context();
    const clang::QualType type = field.getType();
    const bool isUnion = type->isUnionType() && type.isTriviallyCopyableType(context) && !type.isConstQualified();
    if (!isUnion || field.isAnonymousStructOrUnion()) return unsuited(field);
    const auto size = static_cast<std::uint64_t>(context.getTypeSizeInChars(type).getQuantity());
    const model::TypeUse byte{TypeKind::Scalar, "unsigned char", "/uint8_t", {}, ""};
    const std::string name = field.getNameAsString(), count = std::to_string(size);
    Classified bytes;
    bytes.use = model::TypeUse{TypeKind::Sequence,
                               "std::array<unsigned char, " + count + ">",
                               "/std/array</uint8_t," + count + ">",
                               {byte},
                               ""};
    return {bytes, {AccessKind::Bytes, name, name}};
}

/// Shows the pointee of a std::shared_ptr or std::unique_ptr as a sequence with one element or none.
FieldForm byValue(const clang::FieldDecl& field, TypeDescriber& types) {
    const clang::QualType type = field.getType();
    const auto* shared = instanceOf(type, "shared_ptr");
    const auto* unique = instanceOf(type, "unique_ptr");
    if (shared == nullptr && unique == nullptr) return unsuited(field);
    const clang::TemplateArgumentList& arguments = (shared != nullptr ? shared : unique)->getTemplateArgs();
    const clang::QualType pointee = arguments[0].getAsType();
    const bool ownDeleter = unique != nullptr && instanceOf(arguments[1].getAsType(), "default_delete") == nullptr;
    if (pointee->isArrayType() || type.isConstQualified() || ownDeleter) return unsuited(field);
    Classified pointer = classifyValue(pointee.getUnqualifiedType(), types.context());
    if (!pointer.use) return {pointer};
    const model::TypeUse value = *pointer.use;
    pointer.use = model::TypeUse{
        TypeKind::Optional, "std::optional<" + value.cpp + ">", "/std/optional<" + value.name + ">", {value}, ""};
    const std::string name = field.getNameAsString();
    model::FieldAccess access{shared != nullptr ? AccessKind::Shared : AccessKind::Unique, name, name};
    access.pointee = (pointee.isConstQualified() ? "const " : "") + value.cpp;
    return {pointer, access};
}

/// If the author of the struct defines how it is copied, its atomic numbers are ordinary fields.
FieldForm asLoaded(const clang::FieldDecl& field, clang::QualType number, TypeDescriber& types) {
    if (!isCopyable(*llvm::cast<clang::CXXRecordDecl>(field.getParent()), types.sema()))
        return {reject(Reason::Atomic, field.getType())};
    const std::string name = field.getNameAsString();
    return {classifyValue(number, types.context()), {AccessKind::Atomic, name, name}};
}

/// A constant member is read-only.
std::optional<FieldForm> asConstant(const clang::FieldDecl& field, TypeDescriber& types) {
    const clang::ASTContext& context = types.context();
    const clang::QualType type = field.getType();
    const bool isArray = type->isConstantArrayType();
    const bool isConst = isArray ? context.getBaseElementType(type).isConstQualified() : type.isConstQualified();
    if (!isConst || type.isVolatileQualified()) return std::nullopt;
    if (isArray && !type.isTriviallyCopyableType(context)) return FieldForm{reject(Reason::ConstMember, type)};
    return FieldForm{classifyValue(context.getUnqualifiedArrayType(type), context),
                     {isArray ? AccessKind::Bytes : AccessKind::Copy, field.getNameAsString()}};
}

}  // namespace

std::optional<FieldForm> formOf(const clang::FieldDecl& field, const DocComment& doc, TypeDescriber& types) {
    if (doc.asText) return asText(field, types);
    const auto* tag = field.getType()->getAsTagDecl();
    if (doc.bytes || (tag != nullptr && tag->isUnion() && types.docOf(*tag).bytes)) return asBytes(field, types);
    if (doc.byValue) return byValue(field, types);
    if (const auto* atomic = instanceOf(field.getType(), "atomic"))
        return asLoaded(field, atomic->getTemplateArgs()[0].getAsType(), types);
    return asConstant(field, types);
}

}  // namespace oroforge::cxx
