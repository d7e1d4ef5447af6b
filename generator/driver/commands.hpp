// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The jobs of orocreate-pkg. They report to the sink, write nothing after an error, and list on `out` what they wrote.
#ifndef OROFORGE_GENERATOR_DRIVER_COMMANDS_HPP
#define OROFORGE_GENERATOR_DRIVER_COMMANDS_HPP

#include <iosfwd>

#include <diag/sink.hpp>
#include <driver/options.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

/// Makes a new package below the current directory.
void createPackage(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

/// --generate makes base classes from a manifest. Prints only what --list-outputs and --dump ask for.
void generateComponents(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

/// --add adds a part to the package in the current directory: writes new sources and puts their targets before
/// orocos_generate_package() in CMakeLists.txt; nothing else changes. Errors: OC009 no package here, OC010 a file
/// exists already, OC011 no place in CMakeLists.txt.
void addPart(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

/// --update makes the user's classes follow a change of the manifest.
///
///     manifest ─► model ─► checks ─► wanted classes ─┐
///     sources, with generated bases in memory ─► user code ├─► merge::plan ─► all files or none
///     .orocreate-pkg.json ─► record ─────────────────┘
void updatePackage(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

/// --describe writes the manifest of the component classes in the given headers and sources to `out` or into a file.
/// Writes nothing if one of them does not compile; what the source does not reveal is a warning.
void describeComponents(const Options& options, std::ostream& out, diag::Sink& sink);

/// --upgrade adapts packages that were made for the original toolchain. In each manifest.xml in the folders or below,
/// it turns a <depend package="…"/> on a part of the toolchain into a <rosdep name="…"/>. Keeps the old file as
/// manifest.xml.old, unless -f is given. Without a manifest: error OC013.
void upgradePackages(const Options& options, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
