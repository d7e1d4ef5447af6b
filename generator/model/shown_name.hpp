// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MODEL_SHOWN_NAME_HPP
#define OROFORGE_GENERATOR_MODEL_SHOWN_NAME_HPP

#include <string>

namespace oroforge::model {

/// Returns the type without the leading "::" of its names: "Box<demo::Point>" for "::Box<::demo::Point>".
std::string cppShown(const std::string& type);

}  // namespace oroforge::model

#endif
