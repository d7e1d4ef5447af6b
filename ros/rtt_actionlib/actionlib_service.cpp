// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service `actionlib`, by which scripts connect the action servers and clients of a component.
#include <rtt/Logger.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt_actionlib/rtt_actionlib.h>

#include <algorithm>
#include <string>

namespace rtt_actionlib {

class ActionlibService : public RTT::Service {
public:
    explicit ActionlibService(RTT::TaskContext* owner) : RTT::Service("actionlib", owner) {
        doc("Connects the ports of action servers and clients to topics of ROS.");
        addOperation("connect", &ActionlibService::connect, this)
            .doc("Connects the action of the component to the topics of a namespace; false if that fails.")
            .arg("action_ns", "namespace of the action");
        addOperation("connectSub", &ActionlibService::connectSub, this)
            .doc("The same for the action of one of its services.")
            .arg("service_name", "service with the ports, such as arm or arm.left")
            .arg("action_ns", "namespace of the action");
    }

private:
    bool connect(const std::string& action_ns) {
        return getOwner() && connectPorts(getOwner()->provides(), action_ns);
    }

    bool connectSub(const std::string& service_name, const std::string& action_ns) {
        if (!getOwner()) return false;
        RTT::Service::shared_ptr service = getOwner()->provides();
        for (std::size_t begin = 0; begin <= service_name.size();) {
            const std::size_t end = std::min(service_name.find('.', begin), service_name.size());
            const std::string name = service_name.substr(begin, end - begin);
            if (!service->hasService(name)) {
                RTT::log(RTT::Error) << "component '" << getOwner()->getName() << "' has no service '" << service_name
                                     << "', so action '" << action_ns << "' was not connected" << RTT::endlog();
                return false;
            }
            service = service->provides(name);
            begin = end + 1;
        }
        return connectPorts(service, action_ns);
    }

    static bool connectPorts(const RTT::Service::shared_ptr& service, const std::string& action_ns) {
        ActionBridge bridge;
        return bridge.setPortsFromService(service) && bridge.createStream(action_ns);
    }
};

}  // namespace rtt_actionlib

ORO_SERVICE_NAMED_PLUGIN(rtt_actionlib::ActionlibService, "actionlib")
