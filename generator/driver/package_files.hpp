// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The files of a package, and their contents.
#ifndef OROFORGE_GENERATOR_DRIVER_PACKAGE_FILES_HPP
#define OROFORGE_GENERATOR_DRIVER_PACKAGE_FILES_HPP

#include <iosfwd>
#include <string>
#include <vector>

#include <emit/outputs.hpp>
#include <model/package.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

/// Returns the files that each build makes, below the output directory: base classes and registration.
emit::Outputs generatedFiles(const model::Package& package, const std::string& manifest,
                             const render::Renderer& renderer);

/// Returns their names from the class names, without rendering.
std::vector<std::string> generatedFileNames(const model::Package& package);

/// Returns the user's files for one class, including its test.
std::vector<std::string> classFileNames(const std::string& className, bool isComponent);

/// Files that are written once when a package is made.
struct Scaffold {
    emit::Outputs shared;  ///< CMakeLists.txt, package.xml …: made again when forced
    emit::Outputs user;    ///< classes, types, tests: never overwritten
};

/// `catkin`: for a catkin workspace, which has its own top-level build.
Scaffold scaffold(const model::Package& package, const std::string& manifest, bool catkin,
                  const render::Renderer& renderer);

/// Returns the sources and tests of the package's skeletons.
emit::Outputs skeletonFiles(const model::Package& package, const render::Renderer& renderer);

/// Writes all or nothing below `directory` and prints "wrote FILE" for each change; with `dryRun` only "would write".
bool writeOutputs(const emit::Outputs& outputs, const std::string& directory, bool dryRun, std::ostream& out,
                  diag::Sink& sink);

}  // namespace oroforge::driver

#endif
