// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_DRIVER_WANTED_CLASSES_HPP
#define OROFORGE_GENERATOR_DRIVER_WANTED_CLASSES_HPP

#include <string>
#include <vector>

#include <merge/record.hpp>
#include <merge/wanted.hpp>
#include <model/package.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

/// Returns what a manifest wants in the user's classes; bodies of hooks come from the templates.
std::vector<merge::WantedClass> wantedClasses(const model::Package& package, const render::Renderer& renderer);

/// Returns the record of a new package; empty if it has no classes.
std::string firstRecord(const model::Package& package, const render::Renderer& renderer);

}  // namespace oroforge::driver

#endif
