// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DATA_FLOW_I_H
#define ORO_CORBA_DATA_FLOW_I_H

#include <rtt/rtt-config.h>
#include <rtt/transports/corba/DataFlowC.h>
#include <rtt/transports/corba/corba.h>

namespace RTT {
namespace corba {

class CDataFlowInterface_i;
class CorbaTypeTransporter;

/**
 * The object by which another process calls one end of a channel: RemoteChannelElement<T> is one. Reference counted;
 * the caller of new owns the first reference. Any thread may call it.
 */
class RTT_API CRemoteChannelElement_i : public POA_RTT::corba::CRemoteChannelElement {
public:
    CRemoteChannelElement_i(CorbaTypeTransporter const& transporter, PortableServer::POA_ptr poa);
    ~CRemoteChannelElement_i() override;

    /** Has the samples that wait sent to the other process. */
    virtual void transferSamples() = 0;
    /** Lets other processes call this object. The caller owns the reference. Throws CORBA::Exception. */
    CRemoteChannelElement_ptr activate_this();
    /** Not used by the library. */
    void setCDataFlowInterface(CDataFlowInterface_i* dataflow) { mdataflow = dataflow; }
    /** The other end of the channel. */
    void setRemoteSide(CRemoteChannelElement_ptr remote) override;
    PortableServer::POA_ptr _default_POA() override;

protected:
    CRemoteChannelElement_var remote_side;
    CorbaTypeTransporter const& transport;
    PortableServer::POA_var mpoa;
    CDataFlowInterface_i* mdataflow = nullptr;
};

}  // namespace corba
}  // namespace RTT

#endif
