// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_DRIVER_NEW_CLASSES_HPP
#define OROFORGE_GENERATOR_DRIVER_NEW_CLASSES_HPP

#include <filesystem>

#include <diag/sink.hpp>
#include <emit/outputs.hpp>
#include <merge/plan.hpp>
#include <model/package.hpp>
#include <render/renderer.hpp>

namespace oroforge::driver {

struct NewClasses {
    const model::Package& package;
    std::string manifest;
    std::filesystem::path root;
    std::string shown;
    const std::vector<merge::WantedClass>& wanted;
    const merge::Record& record;
    const model::UserCode& code;
};

/// Classes that the manifest has and the package does not: their files, and their lines in CMakeLists.txt. An error OC030 if
/// such a file is there already. A class that is only gone is a warning OC034.
void addNewClasses(const NewClasses& input, const render::Renderer& renderer, emit::Outputs& outputs, merge::Plan& plan,
                   diag::Sink& sink);

}  // namespace oroforge::driver

#endif
