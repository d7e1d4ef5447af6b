// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/master_call.hpp>

#include <ros/master.h>

namespace rtt_roscomm::detail {

bool call(const std::string& host, unsigned port, const char* function, const XmlRpc::XmlRpcValue& request,
          XmlRpc::XmlRpcValue& result, std::chrono::milliseconds limit) {
    XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
    XmlRpc::XmlRpcValue answer;
    if (!client.executeNonBlock(function, request)) return false;
    client._disp.work(std::chrono::duration<double>(limit).count());
    bool isFine = client.executeCheckDone(answer) && !client.isFault();
    try {
        isFine = isFine && answer.getType() == XmlRpc::XmlRpcValue::TypeArray && answer.size() == 3 &&
                 static_cast<int>(answer[0]) == 1;
        if (isFine) result = answer[2];
    } catch (const XmlRpc::XmlRpcException&) {
        isFine = false;
    }
    client._disp.removeSource(&client);
    client.close();
    return isFine;
}

bool callMaster(const char* function, const XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& result,
                std::chrono::milliseconds limit) {
    return call(ros::master::getHost(), ros::master::getPort(), function, request, result, limit);
}

}  // namespace rtt_roscomm::detail
