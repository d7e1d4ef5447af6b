// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/RemoteConnID.hpp>

namespace RTT::corba {

bool RemoteConnID::isSameID(ConnID const& id) const {
    const auto* const other = dynamic_cast<const RemoteConnID*>(&id);
    return other && name == other->name && !CORBA::is_nil(dataflow) && !CORBA::is_nil(other->dataflow) &&
           dataflow->_is_equivalent(other->dataflow);
}

std::string RemoteConnID::toString() const {
    if (!shown_.empty()) return shown_ + " of another process";
    return CORBA::is_nil(dataflow) ? "a port of another process" : "port " + name + " of another process";
}

}  // namespace RTT::corba
