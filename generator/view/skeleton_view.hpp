// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Views of what is written once from a template: sources to begin with, and their targets.
#ifndef OROFORGE_GENERATOR_VIEW_SKELETON_VIEW_HPP
#define OROFORGE_GENERATOR_VIEW_SKELETON_VIEW_HPP

#include <string>

#include <nlohmann/json.hpp>

#include <model/package.hpp>

namespace oroforge::view {

/// For the sources of one skeleton.
nlohmann::json skeletonView(const model::Package& package, const model::Skeleton& skeleton);

/// For the targets of all skeletons of the package.
nlohmann::json skeletonsView(const model::Package& package);

/// "components", "plugins" …: the list of packageView that skeletons of a kind are in.
std::string listOfKind(model::SkeletonKind kind);

/// "Controller" → "controller": the usual name of an instance.
std::string instanceName(const std::string& className);

}  // namespace oroforge::view

#endif
