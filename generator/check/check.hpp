// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Rules a package must keep beyond the structure of its manifest. One file per group of rules.
#ifndef OROFORGE_GENERATOR_CHECK_CHECK_HPP
#define OROFORGE_GENERATOR_CHECK_CHECK_HPP

#include <string>

#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::check {

/// All rules; everything that is wrong is reported (codes OM010 to OM059).
void run(const model::Package& package, diag::Sink& sink);

/// Names of packages, classes, ports …: what may be written (OM010, OM011, OM013 to OM017).
void names(const model::Package& package, diag::Sink& sink);
/// Nothing may have the name of something else (OM012).
void duplicates(const model::Package& package, diag::Sink& sink);
/// Spelling of C++ types (OM020 to OM023).
void types(const model::Package& package, diag::Sink& sink);
/// Defaults and ranges fit their types and each other (OM030 to OM035).
void values(const model::Package& package, diag::Sink& sink);
/// Period, priority and scheduler fit the kind of activity (OM040 to OM042).
void activities(const model::Package& package, diag::Sink& sink);
/// Events and policies of ports (OM050 to OM053).
void ports(const model::Package& package, diag::Sink& sink);

/// Empty if `name` can be a package; else why not, as the end of a sentence.
std::string packageNameFault(const std::string& name);

}  // namespace oroforge::check

#endif
