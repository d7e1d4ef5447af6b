// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "classify.hpp"

#include "type_names.hpp"

namespace oroforge::cxx {

namespace {

Classified classifyBuiltin(clang::QualType type, const clang::BuiltinType& builtin, const clang::ASTContext& context) {
    Classified result;
    if (const auto name = nameOf(builtin, context)) {
        result.use = model::TypeUse{model::TypeKind::Scalar, name->cpp, name->registry, {}};
        return result;
    }
    if (type->isWideCharType() || type->isChar8Type() || type->isChar16Type() || type->isChar32Type()) {
        return reject(Reason::CharacterType, type);
    }
    return reject(type->isArithmeticType() ? Reason::WideScalar : Reason::OtherType, type);
}

Classified classifyEnum(clang::QualType type, const clang::EnumDecl& declaration) {
    if (isStandard(declaration)) return reject(Reason::OtherStandard, type);
    const auto name = nameOf(declaration);
    if (!name) return reject(Reason::Unnamed, type);
    Classified result;
    result.use = model::TypeUse{model::TypeKind::Enum, name->cpp, name->registry, {}};
    result.enumeration = &declaration;
    return result;
}

Classified classifyRecord(clang::QualType type, const clang::CXXRecordDecl& record, const clang::ASTContext& context) {
    if (record.isUnion()) return reject(Reason::Union, type);
    if (isStandard(record)) return classifyStandard(type, record, context);
    if (record.isLambda()) return reject(Reason::Callable, type);
    const auto name = nameOf(record);
    if (!name) {
        const bool instance = llvm::isa<clang::ClassTemplateSpecializationDecl>(record);
        return reject(instance ? Reason::TemplateArgument : Reason::Unnamed, type);
    }
    Classified result;
    result.use = model::TypeUse{model::TypeKind::Struct, name->cpp, name->registry, {}};
    result.record = &record;
    return result;
}

Classified classifyArray(clang::QualType array, clang::QualType element, std::uint64_t count,
                         const clang::ASTContext& context) {
    if (count == 0) return reject(Reason::UnboundedArray, array);
    Classified result = classifyMember(element, context);
    if (result.use && result.count != 0) return reject(Reason::MultiDimArray, array);
    result.count = count;
    return result;
}

}  // namespace

Classified classifyValue(clang::QualType type, const clang::ASTContext& context) {
    const clang::Type& bare = *type.getCanonicalType().getUnqualifiedType();
    if (const auto* builtin = llvm::dyn_cast<clang::BuiltinType>(&bare))
        return classifyBuiltin(type, *builtin, context);
    if (bare.isFunctionPointerType() || bare.isMemberPointerType()) return reject(Reason::Callable, type);
    if (bare.isPointerType())
        return reject(bare.getPointeeType()->isCharType() ? Reason::CString : Reason::RawPointer, type);
    if (bare.isReferenceType()) return reject(Reason::Reference, type);
    if (bare.isArrayType()) return reject(Reason::ArrayElement, type);
    if (const auto* tag = llvm::dyn_cast<clang::EnumType>(&bare)) return classifyEnum(type, *tag->getDecl());
    if (const auto* record = bare.getAsCXXRecordDecl()) return classifyRecord(type, *record, context);
    return reject(bare.isArithmeticType() ? Reason::WideScalar : Reason::OtherType, type);
}

Classified classifyMember(clang::QualType type, const clang::ASTContext& context) {
    if (type->isReferenceType()) return reject(Reason::Reference, type);
    if (const auto* array = context.getAsConstantArrayType(type)) {
        return classifyArray(type, array->getElementType(), array->getSize().getZExtValue(), context);
    }
    if (type->isArrayType()) return reject(Reason::UnboundedArray, type);
    if (type.isVolatileQualified()) return reject(Reason::VolatileMember, type);
    if (type.isConstQualified()) return reject(Reason::ConstMember, type);
    const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
    if (instance != nullptr && isStandard(*instance, "array")) {
        const clang::TemplateArgumentList& arguments = instance->getTemplateArgs();
        return classifyArray(type, arguments[0].getAsType(), arguments[1].getAsIntegral().getZExtValue(), context);
    }
    return classifyValue(type, context);
}

}  // namespace oroforge::cxx
