// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_MESSAGES_ADDED_SERVICES_HPP
#define OROFORGE_TESTS_ROS_MESSAGES_ADDED_SERVICES_HPP

#include <rtt_roscomm/message_table.hpp>

#include <vector>

/** What plugins of services have told. */
std::vector<rtt_roscomm::ServiceEntry>& addedServices();

#endif
