// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Schemas of types: plugins compare them to find out whether they see a type in the same way.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_SCHEMA_VIEW_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_SCHEMA_VIEW_HPP

#include <model/type_model.hpp>
#include <nlohmann/json.hpp>

namespace oroforge::typekit {

/// True for structs and enums of the user, and for types made from them.
bool isOfUserType(const model::TypeUse& use);

/// Entries for structs, enums, tuples and variants: key, cpp, name, isEnum, fields[] with name, type, place, unit, of.
nlohmann::json schemaViews(const model::TypeModel& model);

}  // namespace oroforge::typekit

#endif
