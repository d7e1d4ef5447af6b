// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_TRANSPORTER_HPP
#define ORO_TYPE_TRANSPORTER_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/PortInterface.hpp>

namespace RTT {
namespace types {

/** Connects ports of one type to one kind of transport. */
class RTT_API TypeTransporter {
public:
    virtual ~TypeTransporter();

    /**
     * A channel element that sends (`is_sender`) or receives the samples of `port` as `policy` says; null if that
     * cannot be done. Not real-time safe, may block.
     */
    virtual base::ChannelElementBase::shared_ptr createStream(base::PortInterface* port, const ConnPolicy& policy,
                                                              bool is_sender) const = 0;

    /** True for one that knows the type by its shape only: one that was written for the type takes its place. */
    virtual bool isGeneric() const;
};

}  // namespace types
}  // namespace RTT

#endif
