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

/// What a manifest wants in the classes of the user, bodies of hooks as the templates have them.
std::vector<merge::WantedClass> wantedClasses(const model::Package& package, const render::Renderer& renderer);

/// The record of a package that was just made; empty for one without classes.
std::string firstRecord(const model::Package& package, const render::Renderer& renderer);

}  // namespace oroforge::driver

#endif
