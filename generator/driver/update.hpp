// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// --update makes the user's classes follow a change of the manifest.
///
///     manifest ─► model ─► checks ─► wanted classes ─┐
///     sources, with generated bases in memory ─► user code ├─► merge::plan ─► all files or none
///     .orocreate-pkg.json ─► record ─────────────────┘
#ifndef OROFORGE_GENERATOR_DRIVER_UPDATE_HPP
#define OROFORGE_GENERATOR_DRIVER_UPDATE_HPP

#include <iosfwd>

#include <diag/sink.hpp>
#include <driver/options.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

void updatePackage(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
