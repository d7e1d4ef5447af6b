// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_TOPIC_NODE_HPP
#define OROFORGE_TESTS_ROS_TOPIC_NODE_HPP

#include "plain_node.hpp"

namespace ros_test {

/** A node for whose process some plain types have the transport of topics. */
class Node : public PlainNode {
public:
    Node();
};

}  // namespace ros_test

#endif
