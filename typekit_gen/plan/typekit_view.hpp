// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns the model into the JSON that templates/typekit/ reads.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_TYPEKIT_VIEW_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_TYPEKIT_VIEW_HPP

#include <string>

#include <nlohmann/json.hpp>

#include <model/type_model.hpp>

namespace oroforge::typekit {

/// Keys: name, identifier, guard, banner, versionGuard, includes[], externs[], sources[] with word,
/// structs[], enums[], library[], arrays[], instances[], headers[]; where types are messages of ROS also hasMessages,
/// and messages[] with type, name, md5, definition. Texts for C++ are quoted already.
/// `tool` is the name of the generator in the files.
nlohmann::json makeView(const model::TypeModel& model, const std::string& typekit, const std::string& tool = "typegen");

}  // namespace oroforge::typekit

#endif
