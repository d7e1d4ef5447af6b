// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// How generated code registers types of the standard library.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_LIBRARY_VIEW_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_LIBRARY_VIEW_HPP

#include <string>

#include <model/type_model.hpp>
#include <nlohmann/json.hpp>

namespace oroforge::typekit {

/// {"cpp", "name", "maker", "arguments"}, for a struct-like type {"cpp", "name", "fields"} instead; alternatives of a
/// variant under "labels".
nlohmann::json libraryView(const model::TypeUse& use);

/// The entries of a map as a type of their own: like libraryView() of a struct.
nlohmann::json entryView(const model::TypeUse& map);
/// Name of that type in the registry.
std::string entryName(const model::TypeUse& map);

/// The header of the runtime that has the tables of this kind of type; empty if all generated files include it.
std::string libraryHeader(model::TypeKind kind);

/// What scripts and files call an alternative of a variant: "double", "string", "demo::Point".
std::string alternativeName(const model::TypeUse& use);

}  // namespace oroforge::typekit

#endif
