// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The generated files: their names, and their texts from the view.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_TYPEKIT_FILES_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_TYPEKIT_FILES_HPP

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <emit/outputs.hpp>
#include <model/type_model.hpp>
#include <render/renderer.hpp>

namespace oroforge::typekit {

std::string userHeaderName(const std::string& typekit);  ///< "types/NAME/typekit/Types.hpp"

/// The names depend only on the typekit's and its headers' names, so that CMake can ask before anything is read.
std::vector<std::string> outputNames(const std::string& typekit, const std::vector<model::Header>& headers);

/// Returns a text for each of outputNames(). Throws render::RenderError if a template does not fit the view.
emit::Outputs renderTypekit(const nlohmann::json& view, const render::Renderer& renderer);

/// The sources of types alone, for generators with a plugin of their own; `sourceName` is the name of one.
emit::Outputs renderSources(const nlohmann::json& view, const render::Renderer& renderer);
std::string sourceName(const std::string& word);

}  // namespace oroforge::typekit

#endif
