// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// --add KIND NAME adds a part to the package in the current directory.
#ifndef OROFORGE_GENERATOR_DRIVER_ADD_HPP
#define OROFORGE_GENERATOR_DRIVER_ADD_HPP

#include <iosfwd>

#include <diag/sink.hpp>
#include <driver/options.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

/// Writes new sources and puts their targets before orocos_generate_package() in CMakeLists.txt; nothing else changes.
/// Errors: OC009 no package here, OC010 a file exists already, OC011 no place in CMakeLists.txt.
void addPart(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
