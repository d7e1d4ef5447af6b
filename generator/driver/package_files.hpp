// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which files a package consists of, and what is in them.
#ifndef OROFORGE_GENERATOR_DRIVER_PACKAGE_FILES_HPP
#define OROFORGE_GENERATOR_DRIVER_PACKAGE_FILES_HPP

#include <iosfwd>
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

/// The files of the user for one class, its test among them.
std::vector<std::string> classFileNames(const std::string& className, bool isComponent);

/// Files that are written once when a package is made.
struct Scaffold {
    emit::Outputs shared;  ///< CMakeLists.txt, package.xml …: made again when forced
    emit::Outputs user;    ///< classes, types, tests: never written over
};

/// `catkin`: for a workspace of catkin, which brings its own top-level build.
Scaffold scaffold(const model::Package& package, const std::string& manifest, bool catkin,
                  const render::Renderer& renderer);

/// The sources and tests of the package's skeletons.
emit::Outputs skeletonFiles(const model::Package& package, const render::Renderer& renderer);

/// Writes all or nothing below `directory` and tells "wrote FILE" for each that changed; with `dryRun` only "would write".
bool writeOutputs(const emit::Outputs& outputs, const std::string& directory, bool dryRun, std::ostream& out,
                  diag::Sink& sink);

}  // namespace oroforge::driver

#endif
