// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "classify.hpp"

#include <clang/base/type_names.hpp>

namespace oroforge::cxx {

namespace {

Classified classifyBuiltin(clang::QualType type, const clang::BuiltinType& builtin, const clang::ASTContext& context) {
    Classified result;
    if (const auto name = nameOf(builtin, context)) {
        model::TypeKind kind = model::TypeKind::Scalar;
        if (type->isWideCharType() || type->isChar16Type() || type->isChar32Type()) kind = model::TypeKind::Character;
        if (builtin.getKind() == clang::BuiltinType::LongDouble) kind = model::TypeKind::LongDouble;
        result.use = model::TypeUse{kind, name->cpp, name->registry, {}, ""};
        return result;
    }
    const bool isWide = type->isArithmeticType() && !type->isChar8Type();
    return reject(isWide ? Reason::WideScalar : Reason::OtherType, type);
}

/// True for the pointee of `const char*`; an `unsigned char*` points to data.
bool isText(const clang::Type& pointee) {
    return pointee.isSpecificBuiltinType(clang::BuiltinType::Char_S) ||
           pointee.isSpecificBuiltinType(clang::BuiltinType::Char_U);
}

Classified classifyEnum(clang::QualType type, const clang::EnumDecl& declaration) {
    if (isStandard(declaration) && declaration.getName() == "byte") {
        Classified byte;
        byte.use = model::TypeUse{model::TypeKind::Character, "std::byte", "/byte", {}, ""};
        return byte;
    }
    if (isStandard(declaration)) return reject(Reason::OtherStandard, type);
    const auto name = nameOf(declaration);
    if (!name) return reject(unnamedArgument(declaration).empty() ? Reason::Unnamed : Reason::TemplateArgument, type);
    Classified result;
    result.use = model::TypeUse{model::TypeKind::Enum, name->cpp, name->registry, {}, ""};
    result.users = {&declaration};
    return result;
}

Classified classifyRecord(clang::QualType type, const clang::CXXRecordDecl& record, const clang::ASTContext& context) {
    if (record.isUnion()) return reject(Reason::Union, type);
    if (isStandard(record)) return classifyStandard(type, record, context);
    if (record.isLambda()) return reject(Reason::Callable, type);
    const auto name = nameOf(record);
    if (!name) {
        return reject(unnamedArgument(record).empty() ? Reason::Unnamed : Reason::TemplateArgument, type);
    }
    Classified result;
    result.use = model::TypeUse{model::TypeKind::Struct, name->cpp, name->registry, {}, ""};
    result.users = {&record};
    return result;
}

/// Shows rows of `double m[3][4]` as std::array<double, 4>.
Classified asRow(Classified row) {
    if (!row.use || row.count == 0) return row;
    const std::string count = std::to_string(row.count);
    const model::TypeUse element = *row.use;
    row.use = model::TypeUse{model::TypeKind::Sequence,
                             "std::array<" + element.cpp + ", " + count + ">",
                             "/std/array<" + element.name + "," + count + ">",
                             {element},
                             ""};
    row.count = 0;
    return row;
}

/// The element type and size of `E m[N]` and std::array<E, N>; count is 0 for other types.
struct ArrayShape {
    clang::QualType element;
    std::uint64_t count = 0;
    bool isClass = false;
};

ArrayShape shapeOf(clang::QualType type, const clang::ASTContext& context) {
    if (const auto* array = context.getAsConstantArrayType(type))
        return {array->getElementType(), array->getSize().getZExtValue(), false};
    const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
    if (instance == nullptr || !isStandard(*instance, "array")) return {};
    const clang::TemplateArgumentList& arguments = instance->getTemplateArgs();
    return {arguments[0].getAsType(), arguments[1].getAsIntegral().getZExtValue(), true};
}

Classified classifyArray(const ArrayShape& shape, const clang::ASTContext& context) {
    Classified element = classifyMember(shape.element, context);
    if (!element.use) return element;
    const std::string inner = element.declared;
    Classified result = asRow(std::move(element));
    result.count = shape.count;
    const std::string count = std::to_string(shape.count);
    if (shape.isClass) {
        result.declared = "std::array<" + inner + ", " + count + ">";
    } else {
        // The outer bound comes first: three elements of "double[4]" are "double[3][4]".
        std::size_t bounds = inner.size();
        while (inner[bounds - 1] == ']') bounds = inner.rfind('[', bounds - 1);
        result.declared = inner.substr(0, bounds) + "[" + count + "]" + inner.substr(bounds);
    }
    return result;
}

/// True for std::array<int[2], 3>, or a std::array of such arrays.
bool holdsCArrays(const ArrayShape& shape, const clang::ASTContext& context) {
    if (!shape.isClass) return false;
    return shape.element->isConstantArrayType() || holdsCArrays(shapeOf(shape.element, context), context);
}

}  // namespace

Classified classifyValue(clang::QualType type, const clang::ASTContext& context) {
    const clang::Type& bare = *type.getCanonicalType().getUnqualifiedType();
    if (const auto* builtin = llvm::dyn_cast<clang::BuiltinType>(&bare))
        return classifyBuiltin(type, *builtin, context);
    if (bare.isFunctionPointerType() || bare.isMemberPointerType()) return reject(Reason::Callable, type);
    if (bare.isPointerType())
        return reject(isText(*bare.getPointeeType()) ? Reason::CString : Reason::RawPointer, type);
    if (bare.isReferenceType()) return reject(Reason::Reference, type);
    if (const ArrayShape shape = shapeOf(type, context); shape.count != 0) {
        // A value, such as an element of a container, keeps its C++ type, which asRow() would change.
        if (holdsCArrays(shape, context)) return reject(Reason::OtherStandard, type);
        return asRow(classifyArray(shape, context));
    }
    if (bare.isArrayType()) return reject(Reason::UnboundedArray, type);
    if (const auto* tag = llvm::dyn_cast<clang::EnumType>(&bare)) return classifyEnum(type, *tag->getDecl());
    if (const auto* record = bare.getAsCXXRecordDecl()) return classifyRecord(type, *record, context);
    return reject(bare.isArithmeticType() ? Reason::WideScalar : Reason::OtherType, type);
}

Classified classifyMember(clang::QualType type, const clang::ASTContext& context) {
    if (type->isReferenceType()) return reject(Reason::Reference, type);
    if (const ArrayShape shape = shapeOf(type, context); shape.count != 0) return classifyArray(shape, context);
    if (type->isArrayType()) return reject(Reason::UnboundedArray, type);
    if (type.isVolatileQualified()) return reject(Reason::VolatileMember, type);
    if (type.isConstQualified()) return reject(Reason::ConstMember, type);
    Classified result = classifyValue(type, context);
    if (result.use) result.declared = result.use->cpp;
    return result;
}

}  // namespace oroforge::cxx
