// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Fills in Mustache templates from JSON. Knows nothing of models.
///
/// Nothing is escaped: templates make source code, and views quote what needs quotes.
///   {{name}}            string or number that must exist: a misspelt key is a RenderError
///   {{#name}}…{{/name}} list, or "if present": absent, null, false, "" and [] are all "not present"
///   {{^name}}…{{/name}} if not present
///   {{> dir/partial}}   another template of the set, in the same context
/// Keys are looked up from the innermost object outwards; a null in an inner object hides an outer key.
#ifndef OROFORGE_GENERATOR_RENDER_RENDERER_HPP
#define OROFORGE_GENERATOR_RENDER_RENDERER_HPP

#include <stdexcept>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <render/templates.hpp>

namespace oroforge::render {

/// A template does not fit its data: "component/base.hpp: no key 'nmae'".
class RenderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Renderer {
public:
    explicit Renderer(Templates templates);

    /// Throws RenderError for an unknown template, an unknown key or malformed tags.
    std::string render(const std::string& templateName, const nlohmann::json& view) const;

private:
    Templates templates_;
};

}  // namespace oroforge::render

#endif
