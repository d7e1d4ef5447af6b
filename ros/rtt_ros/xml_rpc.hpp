// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROS_XML_RPC_HPP
#define RTT_ROS_XML_RPC_HPP

#include <xmlrpcpp/XmlRpc.h>

#include <chrono>
#include <string>

namespace rtt_ros {

/** Calls a function of a ROS master or node. Calls of roscpp wait for ever if the other end takes the connection and does
    not answer; this one does not wait longer than `limit`. Empty if `result` is the answer, otherwise why there is none. */
std::string callXmlRpc(const std::string& host, unsigned port, const char* function, const XmlRpc::XmlRpcValue& request,
                       XmlRpc::XmlRpcValue& result, std::chrono::milliseconds limit);

/** The same, of the master of this node, for functions whose answer is {code, text, value}: true if the code is 1, and
    `value` is the third part. */
bool callMaster(const char* function, const XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& value,
                std::chrono::milliseconds limit);

}  // namespace rtt_ros

#endif
