// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_PORTS_HPP
#define OROFORGE_LIVE_PORTS_HPP

#include "lookup.hpp"
#include "values.hpp"

#include <rtt/internal/ConnectionManager.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace OCL::live {

/**
 * The ports of all components that the deployer knows, none of which is destroyed while this exists. A port at the
 * other end of a connection is only used if it is one of these, because others may be destroyed at any moment.
 */
class KnownPorts {
public:
    KnownPorts(const Root& root, Visits& visits);

    struct Port {
        std::string component, name;  ///< "Arm", "gripper.force"
        const RTT::base::PortInterface* port;
    };
    const std::vector<Port>& all() const { return all_; }
    const std::vector<std::pair<std::string, RTT::TaskContext*>>& components() const { return components_; }
    /** "Arm.gripper.force"; empty if it is not known. */
    std::string nameOf(const RTT::base::PortInterface* port) const;
    /** The port or stream at the other end of a connection; "another port" if that is not known. */
    std::string partnerOf(const RTT::internal::ConnectionManager::ChannelDescriptor& connection) const;
    /** The last sample of a port, without taking it; null if that is not known. For an input port it is what the output
        port at the other end wrote last. */
    Source lastSample(const RTT::base::PortInterface& port) const;

private:
    void add(const std::string& component, RTT::Service& service, const std::string& prefix, unsigned depth);

    std::vector<Port> all_;
    std::vector<std::pair<std::string, RTT::TaskContext*>> components_;
    std::map<const RTT::base::PortInterface*, std::string> names_;
};

/** "data", "buffer 10", "circular buffer 10". */
std::string policyText(const RTT::ConnPolicy& policy);
std::string typeOfPort(const RTT::base::PortInterface& port);

}  // namespace OCL::live

#endif
