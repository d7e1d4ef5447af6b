// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The kinds of parts of a package, as the command line names them.
#ifndef OROFORGE_GENERATOR_DRIVER_KINDS_HPP
#define OROFORGE_GENERATOR_DRIVER_KINDS_HPP

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <driver/options.hpp>
#include <model/package.hpp>
#include <render/templates.hpp>

namespace oroforge::driver {

/// Returns the package that the words ask for. With --force, parts that it already has stay in its build. Reports OC002
/// for the name, OC003 for a kind, OC008 for a class, namespace or author.
model::Package packageOfKinds(const Options& options, diag::Sink& sink);

/// Returns the part that --add asks for; a typekit has no skeleton.
std::optional<model::Skeleton> skeletonOf(const std::string& kind, const std::string& name, const Options& options);

/// Reports OC003 and returns false if `kind` is not one of `known`.
bool checkKind(const std::string& kind, const std::vector<std::string>& known, diag::Sink& sink);

/// Reports OC008 for malformed names in options.
void checkNames(const Options& options, diag::Sink& sink);

/// "include/PKG/NAME-types.hpp"
std::string typekitHeader(const std::string& package, const std::string& name);

/// --list: prints the kinds with what each makes, then the templates that --template-dir can replace.
void listKinds(const render::Templates& templates, std::ostream& out);

}  // namespace oroforge::driver

#endif
