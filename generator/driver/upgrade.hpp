// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// --upgrade: packages that were made for the original toolchain.
#ifndef OROFORGE_GENERATOR_DRIVER_UPGRADE_HPP
#define OROFORGE_GENERATOR_DRIVER_UPGRADE_HPP

#include <iosfwd>

#include <diag/sink.hpp>
#include <driver/options.hpp>

namespace oroforge::driver {

/// In each manifest.xml of the folders given and below, a <depend package="…"/> on a part of the toolchain becomes a
/// <rosdep name="…"/>. The file as it was is kept as manifest.xml.old, but for -f. OC013: there is none.
void upgradePackages(const Options& options, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
