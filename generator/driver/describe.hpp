// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Describes classes as a manifest (--describe).
#ifndef OROFORGE_GENERATOR_DRIVER_DESCRIBE_HPP
#define OROFORGE_GENERATOR_DRIVER_DESCRIBE_HPP

#include <iosfwd>

#include <driver/options.hpp>

namespace oroforge::driver {

/// Writes the manifest of the component classes in the given headers and sources to `out` or into a file. Writes
/// nothing if one of them does not compile; what the source does not reveal is a warning.
void describeComponents(const Options& options, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
