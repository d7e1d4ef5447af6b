// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Fields that are not shown as their C++ type says, because of an attribute or of the type itself.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIELD_FORMS_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIELD_FORMS_HPP

#include <string>

#include "classify.hpp"
#include "describe_type.hpp"

namespace oroforge::cxx {

struct FieldForm {
    Classified type;
    model::FieldAccess access = {};
};

/// Returns nothing if the field is shown as its C++ type says.
std::optional<FieldForm> formOf(const clang::FieldDecl& field, const DocComment& doc, TypeDescriber& types);

}  // namespace oroforge::cxx

#endif
