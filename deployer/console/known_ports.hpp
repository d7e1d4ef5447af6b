// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_KNOWN_PORTS_HPP
#define OROFORGE_CONSOLE_KNOWN_PORTS_HPP

#include "visits.hpp"

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/internal/ConnectionManager.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace OCL::console {

/**
 * The ports of some components and of all their peers, none of which is destroyed while the visits last. A port at the
 * other end of a connection is only used if it is one of these, because others may be destroyed at any moment.
 */
class KnownPorts {
public:
    KnownPorts(const std::vector<Gate>& roots, Visits& visits);

    struct Port {
        std::string component, name;  ///< "Arm", "gripper.force"
        const RTT::base::PortInterface* port;
    };
    const std::vector<Port>& all() const { return all_; }
    const std::vector<std::pair<std::string, RTT::TaskContext*>>& components() const { return components_; }
    /** "Arm.gripper.force", with the name of the component as its peers call it; empty if it is not known. */
    std::string nameOf(const RTT::base::PortInterface* port) const;
    /** The port or stream at the other end of a connection; its own name if it is no port of these components. */
    std::string partnerOf(const RTT::internal::ConnectionManager::ChannelDescriptor& connection) const;
    /** The last sample of a port, without taking it; null if that is not known. For an input port it is what the output
        port at the other end wrote last. */
    RTT::base::DataSourceBase::shared_ptr lastSample(const RTT::base::PortInterface& port) const;

private:
    void add(const std::string& component, RTT::Service& service, const std::string& prefix, unsigned depth);

    std::vector<Port> all_;
    std::vector<std::pair<std::string, RTT::TaskContext*>> components_;
    std::map<const RTT::base::PortInterface*, std::string> names_;
};

/** The last sample of a port, as KnownPorts of these roots gives it. It is a copy. */
RTT::base::DataSourceBase::shared_ptr lastSampleOf(const RTT::base::PortInterface& port,
                                                   const std::vector<Gate>& roots);

}  // namespace OCL::console

#endif
