// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Decides what a C++ type is to a typekit: a number, a string, a struct …, or why it is unsuitable.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_CLASSIFY_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_CLASSIFY_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include <model/type_model.hpp>

#include "rejection.hpp"

namespace oroforge::cxx {

struct Classified {
    std::optional<model::TypeUse> use;         ///< set if the type is suitable as far as its spelling shows
    std::uint64_t count = 0;                   ///< elements of an array
    std::string declared;                      ///< C++ type of the array
    std::vector<const clang::TagDecl*> users;  ///< the structs and enums that it contains, still to be described
    Reason reason = Reason::OtherType;         ///< if `use` is not set
    clang::QualType culprit;                   ///< the type that `reason` is about: the whole or an element
};

/// Classifies the type of a data member: values and arrays of values.
Classified classifyMember(clang::QualType type, const clang::ASTContext& context);

/// Classifies a value, which containers may hold. Rows of arrays are shown as std::array, which has their layout.
Classified classifyValue(clang::QualType type, const clang::ASTContext& context);

/// Classifies a class of namespace std.
Classified classifyStandard(clang::QualType type, const clang::CXXRecordDecl& record, const clang::ASTContext& context);

inline Classified reject(Reason reason, clang::QualType culprit) {
    Classified result;
    result.reason = reason;
    result.culprit = culprit;
    return result;
}

}  // namespace oroforge::cxx

#endif
