// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_REMOTE_CONN_ID_HPP
#define ORO_REMOTE_CONN_ID_HPP

#include <rtt/internal/ConnID.hpp>
#include <rtt/transports/corba/DataFlowC.h>

#include <string>

namespace RTT {
namespace corba {

/** The other end is a port of another process. */
struct RTT_API RemoteConnID : public internal::ConnID {
    /** `shown`: the full name of the port, if it is known, for messages. */
    RemoteConnID(CDataFlowInterface_ptr interface, const std::string& port, const std::string& shown = std::string())
        : dataflow(CDataFlowInterface::_duplicate(interface)), name(port), shown_(shown) {}
    bool isSameID(ConnID const& id) const override;
    RemoteConnID* clone() const override { return new RemoteConnID(dataflow, name, shown_); }
    std::string toString() const override;

    const CDataFlowInterface_var dataflow;
    const std::string name;

private:
    const std::string shown_;
};

}  // namespace corba
}  // namespace RTT

#endif
