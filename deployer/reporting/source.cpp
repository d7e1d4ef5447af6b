// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "source.hpp"

#include <rtt/internal/ConnectionManager.hpp>

namespace OCL::reporting {

Source::Source(const std::string& component, std::string path, std::unique_ptr<RTT::base::InputPortInterface> port,
               Value sample)
    : component_(component),
      path_(std::move(path)),
      name_(component_ + "." + path_),
      port_(std::move(port)),
      link_(new RTT::internal::PortLink(*port_)),
      sample_(std::move(sample)),
      address_(sample_->getRawPointer()) {}

Source::Source(const std::string& component, std::string path, Value original, Gate peer, Value sample)
    : component_(component),
      path_(std::move(path)),
      name_(component_ + "." + path_),
      original_(std::move(original)),
      peer_(std::move(peer)),
      sample_(std::move(sample)),
      address_(sample_->getRawPointer()) {}

void Source::prepare() {
    if (!link_) {
        (void)read();
    } else if (!read() && !hasSample_) {
        for (const auto& connection : port_->getManager()->getConnections())
            if (boost::get<1>(connection)->getSampleErased(address_)) break;
    }
}

bool Source::read() {
    if (link_) {
        const RTT::FlowStatus status = link_->read(address_);
        hasSample_ = hasSample_ || status != RTT::NoData;
        return status == RTT::NewData;
    }
    // The value may lie within the peer.
    const RTT::internal::EngineGate::Visit peer(*peer_);
    if (peer.engine()) (void)sample_->update(original_.get());
    return false;
}

void Source::clear() {
    if (port_) port_->clear();
}

}  // namespace OCL::reporting
