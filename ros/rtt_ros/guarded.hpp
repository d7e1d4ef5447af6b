// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROS_GUARDED_HPP
#define RTT_ROS_GUARDED_HPP

#include <xmlrpcpp/XmlRpcException.h>

#include <exception>
#include <string>

namespace rtt_ros {

/** Calls a function that uses roscpp; the text of what it throws, never empty, or "" if it returns. */
template <class Function>
std::string problemIn(Function&& function) {
    std::string text;
    try {
        function();
        return {};
    } catch (const XmlRpc::XmlRpcException& error) {  // is no std::exception
        text = "XML-RPC: " + error.getMessage();
    } catch (const std::exception& error) {
        text = error.what();
    }
    return text.empty() ? "unknown error" : text;
}

}  // namespace rtt_ros

#endif
