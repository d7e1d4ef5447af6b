// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_TRANSPORTER_HPP
#define ORO_TYPE_TRANSPORTER_HPP

#include <rtt/rtt-config.h>
#include <boost/intrusive_ptr.hpp>

namespace RTT {

class ConnPolicy;
namespace base {
class PortInterface;
class ChannelElementBase;
}  // namespace base

namespace types {

/** Connects ports of one type to one kind of transport. */
class RTT_API TypeTransporter {
public:
    virtual ~TypeTransporter();

    /**
     * A channel element that sends (`is_sender`) or receives the samples of `port` as `policy` says; null if that
     * cannot be done. Not real-time safe, may block.
     */
    virtual boost::intrusive_ptr<base::ChannelElementBase> createStream(base::PortInterface* port,
                                                                        const ConnPolicy& policy,
                                                                        bool is_sender) const = 0;
};

}  // namespace types
}  // namespace RTT

#endif
