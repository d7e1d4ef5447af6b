// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// From the view to the texts of all generated files.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_RENDER_TYPEKIT_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_RENDER_TYPEKIT_HPP

#include <nlohmann/json_fwd.hpp>

#include <emit/outputs.hpp>
#include <render/renderer.hpp>

namespace oroforge::typekit {

/// One text for each of outputNames(). Throws render::RenderError if a template does not fit the view.
emit::Outputs renderTypekit(const nlohmann::json& view, const render::Renderer& renderer);

}  // namespace oroforge::typekit

#endif
