// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What a C++ type is to a typekit: a number, a string, a struct …, or why it is none of them.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_CLASSIFY_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_CLASSIFY_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include <model/type_model.hpp>

#include "rejection.hpp"

namespace oroforge::cxx {

struct Classified {
    std::optional<model::TypeUse> use;         ///< set: the type is fine as far as it can be seen from here
    std::uint64_t count = 0;                   ///< elements, if it is an array …
    std::string declared;                      ///< … whose C++ type is this
    std::vector<const clang::TagDecl*> users;  ///< structs and enums at the bottom, still to be described
    Reason reason = Reason::OtherType;         ///< if use is not set …
    clang::QualType culprit;                   ///< … and the type it is about: the whole, or an element
};

/// Type of a data member: values and arrays of values.
Classified classifyMember(clang::QualType type, const clang::ASTContext& context);

/// A value: everything that may be an element of a container. Rows of arrays are seen as std::array, which has their layout.
Classified classifyValue(clang::QualType type, const clang::ASTContext& context);

/// A class of namespace std.
Classified classifyStandard(clang::QualType type, const clang::CXXRecordDecl& record, const clang::ASTContext& context);

inline Classified reject(Reason reason, clang::QualType culprit) {
    Classified result;
    result.reason = reason;
    result.culprit = culprit;
    return result;
}

}  // namespace oroforge::cxx

#endif
