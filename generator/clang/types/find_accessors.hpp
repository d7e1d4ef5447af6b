// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the public functions that read and write a private field.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIND_ACCESSORS_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIND_ACCESSORS_HPP

#include <optional>
#include <string>

#include <clang/base/llvm_compat.hpp>
#include <model/field_access.hpp>

namespace oroforge::cxx {

struct Accessors {
    std::string name;  ///< the field's, without private marks: "width" for "m_width", "_width", "width_"
    model::FieldAccess access;
};

/// Finds a getter of a field `width_`: width(), getWidth() or get_width(), const and of the field's type, with a setter
/// setWidth(), set_width() or width() for such a value; or a width() that returns a reference. Else nothing.
std::optional<Accessors> findAccessors(const clang::FieldDecl& field);

}  // namespace oroforge::cxx

#endif
