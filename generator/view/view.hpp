// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns the model into JSON, the only input of templates. All decisions about generated text are taken here: templates
/// only say "for each" and "if present". A null key is an absent feature.
#ifndef OROFORGE_GENERATOR_VIEW_VIEW_HPP
#define OROFORGE_GENERATOR_VIEW_VIEW_HPP

#include <string>

#include <nlohmann/json.hpp>

#include <model/package.hpp>

namespace oroforge::view {

/// `manifest` is the file name shown in generated files.
nlohmann::json componentView(const model::Package& package, const model::Component& component,
                             const std::string& manifest);

/// Returns the view of a service class that components load.
nlohmann::json serviceView(const model::Package& package, const model::ServicePlugin& service,
                           const std::string& manifest);

/// Returns the view of the registration of all components.
nlohmann::json registrationView(const model::Package& package, const std::string& manifest);

/// Returns the view of the files around the components: CMakeLists.txt, package.xml, README, deployment.
nlohmann::json packageView(const model::Package& package, const std::string& manifest);

/// Returns the view of the reference documentation, in Markdown.
nlohmann::json referenceView(const model::Package& package, const std::string& manifest);

/// Returns the view of a typekit header: structs for the types of the package's own namespaces that components use.
nlohmann::json typekitView(const model::Package& package, const std::string& header);

}  // namespace oroforge::view

#endif
