// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Views of files that are written once from a template: sources to begin with, and their targets.
#ifndef OROFORGE_GENERATOR_VIEW_SKELETON_VIEW_HPP
#define OROFORGE_GENERATOR_VIEW_SKELETON_VIEW_HPP

#include <string>

#include <nlohmann/json.hpp>

#include <model/package.hpp>

namespace oroforge::view {

/// Returns the view for the sources of one skeleton.
nlohmann::json skeletonView(const model::Package& package, const model::Skeleton& skeleton);

/// Returns the view for the targets of all skeletons of the package.
nlohmann::json skeletonsView(const model::Package& package);

/// Returns "components", "plugins" …: the key of packageView() that lists skeletons of this kind.
std::string listOfKind(model::SkeletonKind kind);

/// Returns the usual name of an instance: "controller" for "Controller".
std::string instanceName(const std::string& className);

}  // namespace oroforge::view

#endif
