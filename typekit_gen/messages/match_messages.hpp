// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the messages of ROS that structs are said to be, and checks that they are.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_MATCH_MESSAGES_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_MATCH_MESSAGES_HPP

#include <diag/sink.hpp>
#include <model/type_model.hpp>

namespace oroforge::messages {

/// Fills `messages` of a closed model, and adds the .msg files to its `files`. Without a struct that has a message
/// nothing is done, and no file is looked for. Errors TK080 to TK082, and RM001 to RM007 about the messages; TK083 is a
/// warning: fields that are likely to be in another order.
void matchMessages(model::TypeModel& model, diag::Sink& sink);

}  // namespace oroforge::messages

#endif
