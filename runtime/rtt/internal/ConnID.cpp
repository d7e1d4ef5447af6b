// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/ConnID.hpp>

#include <rtt/base/PortInterface.hpp>

namespace RTT::internal {

ConnID::~ConnID() = default;

LocalConnID::LocalConnID(base::PortInterface const* port)
    : ptr(port), name_(port ? port->getFullName() : "(no port)") {}

bool LocalConnID::isSameID(ConnID const& id) const {
    const LocalConnID* other = dynamic_cast<const LocalConnID*>(&id);
    return other && other->ptr == ptr;
}

LocalConnID* LocalConnID::clone() const { return new LocalConnID(*this); }
std::string LocalConnID::toString() const { return name_; }

bool StreamConnID::isSameID(ConnID const& id) const {
    const StreamConnID* other = dynamic_cast<const StreamConnID*>(&id);
    return other && other->name_id == name_id;
}

StreamConnID* StreamConnID::clone() const { return new StreamConnID(name_id); }
std::string StreamConnID::toString() const { return name_id; }

OutOfBandConnID* OutOfBandConnID::clone() const { return new OutOfBandConnID(name_id, partner_); }

bool SharedConnID::isSameID(ConnID const& id) const {
    return dynamic_cast<const SharedConnID*>(&id) && StreamConnID::isSameID(id);
}

SharedConnID* SharedConnID::clone() const { return new SharedConnID(name_id); }

}  // namespace RTT::internal
