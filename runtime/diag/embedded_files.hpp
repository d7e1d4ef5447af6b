// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Files compiled into a program by cmake/OroforgeEmbed.cmake.
#ifndef OROFORGE_DIAG_EMBEDDED_FILES_HPP
#define OROFORGE_DIAG_EMBEDDED_FILES_HPP

#include <string_view>
#include <vector>

namespace oroforge::diag {

struct EmbeddedFile {
    std::string_view name;  ///< relative to the embedded folder, without ".txt" or ".mustache": "component/base.hpp"
    std::string_view text;
};
using EmbeddedFiles = std::vector<EmbeddedFile>;

}  // namespace oroforge::diag

#endif
