// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What distinguishes a message on the network: its md5 sum, and its complete definition.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_IDENTITY_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_IDENTITY_HPP

#include <string>

#include <messages/message_set.hpp>

namespace oroforge::messages {

/// All that the message is made of must be in the set.
std::string md5Of(const Message& message, const MessageSet& set);
std::string md5Of(const Service& service, const MessageSet& set);

/// Returns the text of the file, followed by those of all messages in it, each once, as roscpp sends it.
std::string definitionOf(const Message& message, const MessageSet& set);

}  // namespace oroforge::messages

#endif
