// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The kinds of parts that a package can be made of, by the words of the command line.
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

/// The package that the words ask for. Parts that a forced package already has stay in its build. What is wrong with the
/// words is reported: OC002 name, OC003 kind, OC008 class, namespace or author.
model::Package packageOfKinds(const Options& options, diag::Sink& sink);

/// The part that --add asks for; a typekit is no skeleton.
std::optional<model::Skeleton> skeletonOf(const std::string& kind, const std::string& name, const Options& options);

/// Reports OC003 and is false if `kind` is none of `known`.
bool checkKind(const std::string& kind, const std::vector<std::string>& known, diag::Sink& sink);

/// Reports OC008 for names given by options that are none.
void checkNames(const Options& options, diag::Sink& sink);

/// "include/PKG/NAME-types.hpp"
std::string typekitHeader(const std::string& package, const std::string& name);

/// --list: the kinds with what each makes, then the templates that --template-dir can replace.
void listKinds(const render::Templates& templates, std::ostream& out);

}  // namespace oroforge::driver

#endif
