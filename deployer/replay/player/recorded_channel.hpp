// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_RECORDED_CHANNEL_HPP
#define OROFORGE_REPLAY_RECORDED_CHANNEL_HPP

#include "../player.hpp"

#include <reporting/mcap/records.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <string>

namespace OCL::replay {

/** Is the channel that of a port? Properties, attributes, states and logs have channels, too. */
bool isPort(const oroforge::mcap::Channel& channel);

/** Without its count. `schema` may be null. */
Topic topicOf(const oroforge::mcap::Channel& channel, const oroforge::mcap::Schema* schema);

/** The loaded type of the values of a channel: by its name in C++, if the file has that, otherwise by the name in the
    schema, as it is in ROS or IDL. Null, with the reason, if there is none. */
const RTT::types::TypeInfo* typeOf(const oroforge::mcap::Channel& channel, const oroforge::mcap::Schema* schema,
                                   std::string& why);

}  // namespace OCL::replay

#endif
