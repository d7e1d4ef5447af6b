// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LOGGING_CATEGORY_NAME_HPP
#define OROFORGE_LOGGING_CATEGORY_NAME_HPP

#include <rtt/base/ChannelElementBase.hpp>

#include <string>

namespace OCL::logging {

/** The name of the category whose events come through this channel, or of the port if no category writes. */
std::string writerOf(RTT::base::ChannelElementBase& channel);

}  // namespace OCL::logging

#endif
