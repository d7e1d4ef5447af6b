// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// --upgrade adapts packages that were made for the original toolchain.
#ifndef OROFORGE_GENERATOR_DRIVER_UPGRADE_HPP
#define OROFORGE_GENERATOR_DRIVER_UPGRADE_HPP

#include <iosfwd>

#include <diag/sink.hpp>
#include <driver/options.hpp>

namespace oroforge::driver {

/// In each manifest.xml in the folders or below, turns a <depend package="…"/> on a part of the toolchain into a
/// <rosdep name="…"/>. Keeps the old file as manifest.xml.old, unless -f is given. Without a manifest: error OC013.
void upgradePackages(const Options& options, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
