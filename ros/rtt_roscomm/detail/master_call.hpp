// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_MASTER_CALL_HPP
#define RTT_ROSCOMM_DETAIL_MASTER_CALL_HPP

#include <xmlrpcpp/XmlRpc.h>

#include <chrono>
#include <string>

namespace rtt_roscomm::detail {

/** Calls a function of the API of masters or nodes of ROS, without roscpp, which would wait for ever. `result` becomes the
    third part of the answer {code, text, value}. False if there is no answer in time, or if its code is not 1. */
bool call(const std::string& host, unsigned port, const char* function, const XmlRpc::XmlRpcValue& request,
          XmlRpc::XmlRpcValue& result, std::chrono::milliseconds limit);
bool callMaster(const char* function, const XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& result,
                std::chrono::milliseconds limit);

}  // namespace rtt_roscomm::detail

#endif
