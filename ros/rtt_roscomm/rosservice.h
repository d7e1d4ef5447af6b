// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_ROSSERVICE_H
#define RTT_ROSCOMM_ROSSERVICE_H

#include <rtt/OperationCaller.hpp>
#include <rtt/ServiceRequester.hpp>

#include <string>

namespace rtt_roscomm {

/**
 * Connects operations with services of ROS: `component.getProvider<rtt_roscomm::ROSService>("rosservice")`. The operations
 * ask the master, so they block, in the caller's thread; any thread may call them.
 */
class ROSService : public RTT::ServiceRequester {
public:
    explicit ROSService(RTT::TaskContext* owner)
        : RTT::ServiceRequester("rosservice", owner),
          connect("connect"),
          disconnect("disconnect"),
          disconnectAll("disconnectAll") {
        addOperationCaller(connect);
        addOperationCaller(disconnect);
        addOperationCaller(disconnectAll);
    }

    /** Operation or operation caller of the component ("path.name"), name of the service, its type ("std_srvs/Empty"). */
    RTT::OperationCaller<bool(const std::string&, const std::string&, const std::string&)> connect;
    /** All connections of the component with the service of that name. False if there are none. */
    RTT::OperationCaller<bool(const std::string&)> disconnect;
    RTT::OperationCaller<void()> disconnectAll;
};

}  // namespace rtt_roscomm

namespace rtt_rosservice {
using rtt_roscomm::ROSService;
}

#endif
