// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which files a package consists of, and what is in them.
#ifndef OROFORGE_GENERATOR_DRIVER_PACKAGE_FILES_HPP
#define OROFORGE_GENERATOR_DRIVER_PACKAGE_FILES_HPP

#include <string>
#include <vector>

#include <emit/outputs.hpp>
#include <model/package.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

/// Files that are made anew at each build, below the output directory: base classes and registration.
emit::Outputs generatedFiles(const model::Package& package, const std::string& manifest,
                             const render::Renderer& renderer);

/// Their names alone: a function of the class names, nothing is rendered.
std::vector<std::string> generatedFileNames(const model::Package& package);

/// Files that are written once when a package is made.
struct Scaffold {
    emit::Outputs shared;  ///< CMakeLists.txt, package.xml …: made again when forced
    emit::Outputs user;    ///< classes, types, tests: never written over
};

Scaffold scaffold(const model::Package& package, const std::string& manifest, const render::Renderer& renderer);

}  // namespace oroforge::driver

#endif
