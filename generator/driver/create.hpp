// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The two jobs of orocreate-pkg. Both report to the sink and write nothing if there is an error.
#ifndef OROFORGE_GENERATOR_DRIVER_CREATE_HPP
#define OROFORGE_GENERATOR_DRIVER_CREATE_HPP

#include <iosfwd>

#include <driver/options.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

/// A new package below the current directory. Lists what was written on `out`.
void createPackage(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

/// Base classes from a manifest. Silent when it succeeds, except for what --list-outputs and --dump ask for.
void generateComponents(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
