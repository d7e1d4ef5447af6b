// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_EXPECTED_CHANNEL_HPP
#define ORO_CORBA_DETAIL_EXPECTED_CHANNEL_HPP

#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/transports/corba/detail/lost_connections.hpp>

#include <memory>

namespace RTT {
namespace corba {
namespace detail {

/**
 * While one exists, this process waits for a connection from a port of another process, which makes it by calls that do
 * not tell where they come from.
 */
class ExpectedChannel {
public:
    ExpectedChannel(const base::PortInterface& input, const internal::ConnID& id, LostConnections::Ended ended);
    ~ExpectedChannel();
    ExpectedChannel(const ExpectedChannel&) = delete;
    ExpectedChannel& operator=(const ExpectedChannel&) = delete;

    struct Known {
        std::shared_ptr<const internal::ConnID> id;  // null if nothing is expected
        LostConnections::Ended ended;
    };
    /** The channel that this port expects. */
    static Known of(const base::PortInterface& input);

private:
    const base::PortInterface& input_;
    const Known known_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
