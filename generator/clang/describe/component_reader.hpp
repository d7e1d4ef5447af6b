// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads component and service classes: what their constructors add to the interface.
///
///     files ─► one main file that includes them ─► clang AST ─► find_components ─► follow each constructor ─► model
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_COMPONENT_READER_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_COMPONENT_READER_HPP

#include <optional>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::cxx {

struct ComponentFiles {
    std::vector<std::string> files;   ///< headers and sources
    std::vector<std::string> flags;   ///< -I -isystem -D -U -include -std, each word one element
    std::string target = "gnulinux";  ///< value of the macro OROCOS_TARGET
    std::string resourceDir;          ///< clang's own headers; empty = look for them
    std::string root;                 ///< folder of the package
    std::string missingHint;          ///< hint for the first missing #include
};

/// Returns components, services and plugins of the files, and the headers for typegen; finds sources that belong to
/// headers. Returns nothing, after errors, if the files do not compile or have none of these (OC020). What the source
/// does not reveal is a warning.
std::optional<model::Package> readComponents(const ComponentFiles& request, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
