// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The parts of views that components and services have in common.
#ifndef OROFORGE_GENERATOR_VIEW_INTERFACE_VIEW_HPP
#define OROFORGE_GENERATOR_VIEW_INTERFACE_VIEW_HPP

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <model/package.hpp>

namespace oroforge::view {

/// The text, or null if it is empty: then templates take it as not present.
nlohmann::json orNull(const std::string& text);

/// Sets ports, properties, attributes, operations and provided (services) of `top` and of all services in it, each as one
/// list in which entries say where they belong, and has_… and hasRanges.
void putInterface(nlohmann::json& view, const model::Interface& top);

/// Required services with the operations that are called there.
nlohmann::json requirementViews(const std::vector<model::Requirement>& required);

/// All C++ types as they were written.
std::vector<std::string> typesIn(const model::Interface& top, const std::vector<model::Requirement>& required);

}  // namespace oroforge::view

#endif
