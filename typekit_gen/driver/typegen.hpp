// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// typegen as a function: options ─► headers ─► model ─► view ─► texts ─► files.
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_TYPEGEN_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_TYPEGEN_HPP

#include <iosfwd>
#include <string>
#include <vector>

#include <diag/sink.hpp>

#include "options.hpp"

namespace oroforge::typekit {

/// Returns the exit status: 0, or 1 after errors. Writes all files or none. `out` gets only what an option asks for.
int run(const Options& options, diag::Sink& sink, std::ostream& out);

/// The whole program: parses the words, runs, and prints diagnostics to `err`, or to `out` in a --format for programs.
int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

}  // namespace oroforge::typekit

#endif
