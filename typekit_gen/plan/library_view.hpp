// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Describes how generated code registers types of the standard library.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_LIBRARY_VIEW_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_LIBRARY_VIEW_HPP

#include <string>

#include <model/type_model.hpp>
#include <nlohmann/json.hpp>

namespace oroforge::typekit {

/// Keys: cpp, name, maker, arguments, and labels of a variant; of a struct-like type cpp, name, fields.
nlohmann::json libraryView(const model::TypeUse& use);

/// Returns the entries of a map as a type of their own: like libraryView() of a struct.
nlohmann::json entryView(const model::TypeUse& map);
/// Returns the registry name of that type.
std::string entryName(const model::TypeUse& map);

/// Returns the runtime header with the tables of this kind of type; empty if all generated files include it.
std::string libraryHeader(model::TypeKind kind);

/// Returns the name of a variant's alternative in scripts and files: "double", "string", "demo::Point".
std::string alternativeName(const model::TypeUse& use);

}  // namespace oroforge::typekit

#endif
