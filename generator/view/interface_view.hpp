// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The parts of views that components and services share.
#ifndef OROFORGE_GENERATOR_VIEW_INTERFACE_VIEW_HPP
#define OROFORGE_GENERATOR_VIEW_INTERFACE_VIEW_HPP

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <model/package.hpp>

namespace oroforge::view {

/// Returns the text, or null if it is empty: templates treat null as not present.
nlohmann::json orNull(const std::string& text);

/// Sets ports, properties, attributes, operations and provided (services) of `top` and of all services in it, each as
/// one list whose entries name their service, and has_… and hasRanges.
void putInterface(nlohmann::json& view, const model::Interface& top);

/// Returns required services with the operations that the component calls.
nlohmann::json requirementViews(const std::vector<model::Requirement>& required);

/// Returns all C++ types as written.
std::vector<std::string> typesIn(const model::Interface& top, const std::vector<model::Requirement>& required);

}  // namespace oroforge::view

#endif
