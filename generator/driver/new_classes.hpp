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
    const merge::Formatter& format;
};

/// Adds classes that only the manifest has: their files, and their lines in CMakeLists.txt. A file that exists already
/// is error OC030. A class that was removed from the code is warning OC034.
void addNewClasses(const NewClasses& input, const render::Renderer& renderer, emit::Outputs& outputs, merge::Plan& plan,
                   diag::Sink& sink);

}  // namespace oroforge::driver

#endif
