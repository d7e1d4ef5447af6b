// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads the text of .msg and .srv files.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_PARSE_MESSAGE_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_PARSE_MESSAGE_HPP

#include <string>

#include <diag/sink.hpp>
#include <messages/message.hpp>

namespace oroforge::messages {

/// Reports errors RM002 to RM005 with their places; what is wrong is left out of the result. `name` is "Pose".
Message parseMessage(const std::string& text, const std::string& package, const std::string& name,
                     const std::string& file, diag::Sink& sink);

/// The same for a request and a response, which the line "---" separates.
Service parseService(const std::string& text, const std::string& package, const std::string& name,
                     const std::string& file, diag::Sink& sink);

}  // namespace oroforge::messages

#endif
