// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "watch.hpp"

namespace OCL::console {

Watch::Watch(RTT::TaskContext& self, RTT::TaskContext& watched) : self_(self), peer_(watched.getName()) {
    self.addPeer(&watched);
    for (RTT::base::PortInterface* const port : watched.ports()->getPorts()) {
        std::unique_ptr<RTT::base::PortInterface> mine(
            self.getPort(port->getName()) ? nullptr : dynamic_cast<RTT::base::PortInterface*>(port->antiClone()));
        if (!mine) {
            missing_.push_back(port->getName());
            continue;
        }
        self.ports()->addPort(*mine);
        if (!mine->connectTo(port)) missing_.push_back(port->getName());
        ports_.push_back(std::move(mine));
    }
}

Watch::~Watch() {
    for (const auto& port : ports_) {
        port->disconnect();
        self_.ports()->removePort(port->getName());
    }
    self_.removePeer(peer_);
}

}  // namespace OCL::console
