// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The source files and headers of a message package: typekit, transport and services.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_FILES_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_FILES_HPP

#include <string>
#include <vector>

#include <emit/outputs.hpp>
#include <messages/message_model.hpp>
#include <messages/message_set.hpp>
#include <render/renderer.hpp>

namespace oroforge::messages {

/// Returns the names of the files for messages of these names, "Pose" without the package.
std::vector<std::string> messageOutputs(const std::string& package, const std::vector<std::string>& names,
                                        const ModelRules& rules);
/// Returns the files: Plugin.cpp and types_*.cpp of the typekit, Transport.cpp, and headers below include/.
emit::Outputs renderMessages(const std::string& package, const std::vector<const Message*>& messages,
                             const MessageSet& set, const ModelRules& rules, const render::Renderer& renderer);

/// The same for services: Services.cpp, and the types of requests and responses.
std::vector<std::string> serviceOutputs(const std::string& package, const std::vector<std::string>& names,
                                        const ModelRules& rules);
emit::Outputs renderServices(const std::string& package, const std::vector<const Service*>& services,
                             const MessageSet& set, const ModelRules& rules, const render::Renderer& renderer);

/// Returns the other packages that fields of these messages name, sorted.
std::vector<std::string> dependenciesOf(const std::string& package, const std::vector<const Message*>& messages);

}  // namespace oroforge::messages

#endif
