// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DEPLOYED_TEXTS_HPP
#define ORO_DEPLOYED_TEXTS_HPP

#include <rtt/rtt-config.h>

#include <string>
#include <utility>
#include <vector>

namespace RTT::plugin {

/** A file by which a deployer has created components, as it was read. */
struct DeployedText {
    std::string file, text;
};

/** Keeps the text for what tells where data come from, such as recordings. All of them take 1 MiB at most: of what does
    not fit, the name is kept, with a text that says so. A file that is deployed again has the new text. Any thread. */
RTT_API void noteDeployedText(const std::string& file, const std::string& text);
/** In the order in which they were deployed first. Any thread. */
RTT_API std::vector<DeployedText> deployedTexts();

}  // namespace RTT::plugin

#endif
