// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_ros/xml_rpc.hpp>

#include <ros/master.h>

namespace rtt_ros {

using XmlRpc::XmlRpcValue;

std::string callXmlRpc(const std::string& host, unsigned port, const char* function, const XmlRpcValue& request,
                       XmlRpcValue& result, std::chrono::milliseconds limit) {
    typedef std::chrono::steady_clock Clock;
    const Clock::time_point end = Clock::now() + limit;
    XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
    if (!client.executeNonBlock(function, request)) return "it cannot be reached";
    while (!client.executeCheckDone(result)) {
        if (client._disp._sources.empty()) return "it cannot be reached";  // the dispatcher has given up
        const std::chrono::duration<double> left = end - Clock::now();
        if (left.count() <= 0) {
            client._disp.removeSource(&client);
            return "it gives no answer within " + std::to_string(limit.count()) + " ms";
        }
        client._disp.work(left.count());
    }
    if (client.isFault()) return "it refuses " + std::string(function) + ": " + result.toXml();
    if (!result.valid()) return "it cannot be reached";
    return {};
}

bool callMaster(const char* function, const XmlRpcValue& request, XmlRpcValue& value, std::chrono::milliseconds limit) {
    XmlRpcValue answer;
    if (!callXmlRpc(ros::master::getHost(), ros::master::getPort(), function, request, answer, limit).empty())
        return false;
    if (answer.getType() != XmlRpcValue::TypeArray || answer.size() != 3 ||
        answer[0].getType() != XmlRpcValue::TypeInt || static_cast<int>(answer[0]) != 1)
        return false;
    value = answer[2];
    return true;
}

}  // namespace rtt_ros
