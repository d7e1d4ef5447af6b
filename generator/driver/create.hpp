// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The main jobs of orocreate-pkg. They report to the sink and write nothing after an error.
#ifndef OROFORGE_GENERATOR_DRIVER_CREATE_HPP
#define OROFORGE_GENERATOR_DRIVER_CREATE_HPP

#include <iosfwd>

#include <driver/options.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

/// Makes a new package below the current directory. Lists written files on `out`.
void createPackage(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

/// Generates base classes from a manifest. Prints only what --list-outputs and --dump ask for.
void generateComponents(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
