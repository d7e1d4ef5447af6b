// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The templates of a generator.
#ifndef OROFORGE_GENERATOR_RENDER_TEMPLATES_HPP
#define OROFORGE_GENERATOR_RENDER_TEMPLATES_HPP

#include <map>
#include <string>
#include <vector>

#include <diag/embedded_files.hpp>
#include <diag/sink.hpp>

namespace oroforge::render {

/// Name → text. A comment tag at the very beginning ("what this makes, which keys it reads") is not output.
class Templates {
public:
    Templates() = default;
    explicit Templates(const diag::EmbeddedFiles& files);

    void add(const std::string& name, const std::string& text);
    void add(const diag::EmbeddedFiles& files);

    /// Every *.mustache below `directory` replaces an embedded one or is added; false after an error.
    bool overrideFrom(const std::string& directory, diag::Sink& sink);

    /// Returns null if there is no such template.
    const std::string* find(const std::string& name) const;
    std::vector<std::string> names() const;

private:
    std::map<std::string, std::string> texts_;
};

}  // namespace oroforge::render

#endif
