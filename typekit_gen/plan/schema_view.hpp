// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What plugins carry to tell each other how they see a type.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_SCHEMA_VIEW_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_SCHEMA_VIEW_HPP

#include <model/type_model.hpp>
#include <nlohmann/json.hpp>

namespace oroforge::typekit {

/// True for types that are, or are made of, structs and enums of the user.
bool isOfUserType(const model::TypeUse& use);

/// One entry for each struct, enum, and tuple or variant of them: key, cpp, name, isEnum, fields[] with name, type, place,
/// unit, of.
nlohmann::json schemaViews(const model::TypeModel& model);

}  // namespace oroforge::typekit

#endif
