// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_ROS_TEXT_HPP
#define OROFORGE_SCHEMA_ROS_TEXT_HPP

#include "../message_schema.hpp"

#include <string>
#include <vector>

namespace oroforge::schema {

/** Reads message files of ROS 2, one after the other; the first struct is the message itself. False, with the reason
    and the line, if they are not valid. */
bool readRos(const std::string& text, std::vector<Struct>& structs, std::string& why);

}  // namespace oroforge::schema

#endif
