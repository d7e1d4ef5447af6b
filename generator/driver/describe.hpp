// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// From classes to a manifest (--describe).
#ifndef OROFORGE_GENERATOR_DRIVER_DESCRIBE_HPP
#define OROFORGE_GENERATOR_DRIVER_DESCRIBE_HPP

#include <iosfwd>

#include <driver/options.hpp>

namespace oroforge::driver {

/// The manifest of the component classes in the headers and sources that the command line names, on `out` or in a file.
/// Nothing is written if one of them does not compile; what cannot be told from the source is a warning.
void describeComponents(const Options& options, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
