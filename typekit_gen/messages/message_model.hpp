// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns messages into the model from which typekits are made.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_MODEL_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_MODEL_HPP

#include <cstddef>
#include <string>
#include <vector>

#include <messages/message_set.hpp>
#include <model/type_model.hpp>

namespace oroforge::messages {

struct ModelRules {
    std::size_t perSource = 6;          ///< messages that one source file describes
    std::vector<std::string> includes;  ///< further headers of all sources
    bool isForUsers = true;             ///< with types of arrays, and instances of templates for users
};

/// The generated class of a message: "::geometry_msgs::Pose_<std::allocator<void>>".
std::string cppOf(const std::string& fullName);

/// Returns `include` of the header that stands for each source file, which depend only on names.
std::vector<model::Header> headersOf(const std::vector<std::string>& fullNames, const ModelRules& rules);

/// All parts of the messages must be in the set.
model::TypeModel modelOf(const std::vector<const Message*>& messages, const MessageSet& set, const ModelRules& rules);

}  // namespace oroforge::messages

#endif
