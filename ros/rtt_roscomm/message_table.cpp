// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/message_table.hpp>

#include <utility>

namespace rtt_roscomm {

MessageTransport::MessageTransport(std::string package, const MessageEntry* first, std::size_t count)
    : package_(std::move(package)), first_(first), count_(count) {}

bool MessageTransport::registerTransport(std::string, RTT::types::TypeInfo*) { return false; }
std::string MessageTransport::getTransportName() const { return "ros"; }
std::string MessageTransport::getTypekitName() const { return "ros-" + package_; }
std::string MessageTransport::getName() const { return "rtt-ros-" + package_ + "-transport"; }

}  // namespace rtt_roscomm
