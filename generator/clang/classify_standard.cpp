// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <map>

#include "classify.hpp"
#include "type_names.hpp"

namespace oroforge::cxx {

namespace {

const std::map<std::string, Reason>& rejectedTypes() {
    static const std::map<std::string, Reason> all = {
        {"array", Reason::ArrayElement},
        {"basic_string_view", Reason::View},
        {"span", Reason::View},
        {"reference_wrapper", Reason::Reference},
        {"unique_ptr", Reason::SmartPointer},
        {"shared_ptr", Reason::SmartPointer},
        {"weak_ptr", Reason::SmartPointer},
        {"auto_ptr", Reason::SmartPointer},
        {"function", Reason::Callable},
        {"mutex", Reason::Synchronisation},
        {"recursive_mutex", Reason::Synchronisation},
        {"timed_mutex", Reason::Synchronisation},
        {"shared_mutex", Reason::Synchronisation},
        {"condition_variable", Reason::Synchronisation},
        {"condition_variable_any", Reason::Synchronisation},
        {"atomic", Reason::Synchronisation},
        {"atomic_flag", Reason::Synchronisation},
        {"thread", Reason::Synchronisation},
        {"future", Reason::Synchronisation},
        {"promise", Reason::Synchronisation},
        {"map", Reason::Map},
        {"multimap", Reason::Map},
        {"unordered_map", Reason::Map},
        {"unordered_multimap", Reason::Map},
        {"set", Reason::Set},
        {"multiset", Reason::Set},
        {"unordered_set", Reason::Set},
        {"unordered_multiset", Reason::Set},
        {"deque", Reason::OtherSequence},
        {"list", Reason::OtherSequence},
        {"forward_list", Reason::OtherSequence},
        {"queue", Reason::OtherSequence},
        {"stack", Reason::OtherSequence},
        {"priority_queue", Reason::OtherSequence},
        {"valarray", Reason::OtherSequence},
        {"optional", Reason::Optional},
        {"variant", Reason::Variant},
        {"any", Reason::Variant},
        {"pair", Reason::Tuple},
        {"tuple", Reason::Tuple},
        {"complex", Reason::Tuple},
        {"duration", Reason::Time},
        {"time_point", Reason::Time},
    };
    return all;
}

bool isBuiltin(const clang::TemplateArgument& argument, clang::BuiltinType::Kind kind) {
    return argument.getKind() == clang::TemplateArgument::Type && argument.getAsType()->isSpecificBuiltinType(kind);
}

bool isStandardArgument(const clang::TemplateArgument& argument, const char* name) {
    if (argument.getKind() != clang::TemplateArgument::Type) return false;
    const clang::CXXRecordDecl* record = argument.getAsType()->getAsCXXRecordDecl();
    return record != nullptr && isStandard(*record, name);
}

Classified classifyString(clang::QualType type, const clang::TemplateArgumentList& arguments) {
    const bool ofChar =
        isBuiltin(arguments[0], clang::BuiltinType::Char_S) || isBuiltin(arguments[0], clang::BuiltinType::Char_U);
    if (!ofChar || !isStandardArgument(arguments[1], "char_traits")) return reject(Reason::OtherString, type);
    if (!isStandardArgument(arguments[2], "allocator")) return reject(Reason::CustomAllocator, type);
    Classified result;
    result.use = model::TypeUse{model::TypeKind::String, "std::string", "/std/string", {}};
    return result;
}

Classified classifyVector(clang::QualType type, const clang::TemplateArgumentList& arguments,
                          const clang::ASTContext& context) {
    if (isBuiltin(arguments[0], clang::BuiltinType::Bool)) return reject(Reason::VectorOfBool, type);
    if (!isStandardArgument(arguments[1], "allocator")) return reject(Reason::CustomAllocator, type);
    Classified result = classifyValue(arguments[0].getAsType(), context);
    if (!result.use) return result;
    const model::TypeUse element = *result.use;
    result.use = model::TypeUse{
        model::TypeKind::Sequence, "std::vector<" + element.cpp + ">", "/std/vector<" + element.name + ">", {element}};
    return result;
}

}  // namespace

Classified classifyStandard(clang::QualType type, const clang::CXXRecordDecl& record,
                            const clang::ASTContext& context) {
    if (const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record)) {
        if (isStandard(record, "basic_string")) return classifyString(type, instance->getTemplateArgs());
        if (isStandard(record, "vector")) return classifyVector(type, instance->getTemplateArgs(), context);
    }
    const auto known = rejectedTypes().find(record.getNameAsString());
    return reject(known == rejectedTypes().end() ? Reason::OtherStandard : known->second, type);
}

}  // namespace oroforge::cxx
