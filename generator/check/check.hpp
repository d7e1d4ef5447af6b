// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The rules for a package beyond the structure of its manifest. Each group of rules has a file.
#ifndef OROFORGE_GENERATOR_CHECK_CHECK_HPP
#define OROFORGE_GENERATOR_CHECK_CHECK_HPP

#include <string>

#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::check {

/// Checks all rules and reports all errors (codes OM010 to OM059).
void run(const model::Package& package, diag::Sink& sink);

/// Names of packages, classes, ports … have an allowed form (OM010, OM011, OM013 to OM017).
void names(const model::Package& package, diag::Sink& sink);
/// No two things have the same name (OM012).
void duplicates(const model::Package& package, diag::Sink& sink);
/// Spelling of C++ types (OM020 to OM023).
void types(const model::Package& package, diag::Sink& sink);
/// Defaults and ranges fit their types and each other (OM030 to OM035).
void values(const model::Package& package, diag::Sink& sink);
/// Period, priority and scheduler fit the kind of activity (OM040 to OM042).
void activities(const model::Package& package, diag::Sink& sink);
/// Events and policies of ports (OM050 to OM053).
void ports(const model::Package& package, diag::Sink& sink);

/// Returns nothing if `name` can be a package's; else the reason, as the end of a sentence.
std::string packageNameFault(const std::string& name);

}  // namespace oroforge::check

#endif
