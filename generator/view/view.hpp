// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Model → JSON, the only input of templates. All decisions about the text to make are taken here: templates only say
/// "for each" and "if present". A key that is null is a feature that is absent.
#ifndef OROFORGE_GENERATOR_VIEW_VIEW_HPP
#define OROFORGE_GENERATOR_VIEW_VIEW_HPP

#include <string>

#include <nlohmann/json.hpp>

#include <model/package.hpp>

namespace oroforge::view {

/// `manifest` is the file name shown in generated files.
nlohmann::json componentView(const model::Package& package, const model::Component& component,
                             const std::string& manifest);

/// The classes of a service that components load.
nlohmann::json serviceView(const model::Package& package, const model::ServicePlugin& service,
                           const std::string& manifest);

/// The registration of all components of the package.
nlohmann::json registrationView(const model::Package& package, const std::string& manifest);

/// What the files around the components need: CMakeLists.txt, package.xml, README, deployment.
nlohmann::json packageView(const model::Package& package, const std::string& manifest);

/// The reference documentation, as Markdown.
nlohmann::json referenceView(const model::Package& package, const std::string& manifest);

/// A typekit header that declares a struct for every type of the package's own namespaces that its components use.
nlohmann::json typekitView(const model::Package& package, const std::string& header);

}  // namespace oroforge::view

#endif
