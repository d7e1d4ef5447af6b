// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Fields that are shown as something else than their C++ type says, because an attribute or the type itself wants it so.
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

/// Nothing if the field is shown as what it is.
std::optional<FieldForm> formOf(const clang::FieldDecl& field, const DocComment& doc, TypeDescriber& types);

}  // namespace oroforge::cxx

#endif
