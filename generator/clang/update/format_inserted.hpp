// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Formats what is inserted into the user's files as clang-format would.
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_FORMAT_INSERTED_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_FORMAT_INSERTED_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/user_code.hpp>

namespace oroforge::cxx {

struct FormatRequest {
    std::string root;                   ///< the package's folder, absolute
    std::string shown;                  ///< goes before file names in messages
    std::string file;                   ///< relative to root; it need not exist yet
    std::string text;                   ///< of the file, with what is inserted
    std::vector<model::Span> inserted;  ///< bytes of `text`, by place
};

/// Returns the new bytes of each insertion; all other bytes of the text stay. The style is that of the .clang-format
/// nearest to the file. Without one, or with "DisableFormat: true", the insertions stay as they are; one that cannot be
/// used is a warning OC043. Line ends are those that the text has, and an insertion keeps its last one.
std::vector<std::string> formatInserted(const FormatRequest& request, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
