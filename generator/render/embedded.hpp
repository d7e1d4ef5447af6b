// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Templates compiled into a program by cmake/OroforgeEmbed.cmake.
#ifndef OROFORGE_GENERATOR_RENDER_EMBEDDED_HPP
#define OROFORGE_GENERATOR_RENDER_EMBEDDED_HPP

#include <string_view>
#include <vector>

namespace oroforge::render {

struct EmbeddedFile {
    std::string_view name;  ///< below templates/, without ".mustache": "component/base.hpp"
    std::string_view text;
};
using EmbeddedFiles = std::vector<EmbeddedFile>;

}  // namespace oroforge::render

#endif
