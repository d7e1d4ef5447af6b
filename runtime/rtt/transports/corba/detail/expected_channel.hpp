// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_EXPECTED_CHANNEL_HPP
#define ORO_CORBA_DETAIL_EXPECTED_CHANNEL_HPP

#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/transports/corba/detail/lost_connections.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace corba {
namespace detail {

/**
 * While one exists, this process waits for a connection from a port of another process, which makes it by calls that do
 * not tell where they come from. So the other process gets a name for it, which comes back with them.
 *
 * Only the name of another transport's stream cannot be chosen here: a port expects one such stream after the other.
 */
class ExpectedChannel {
public:
    /** Blocks while the port expects another stream, if this is one. */
    ExpectedChannel(const base::PortInterface& input, const internal::ConnID& id, LostConnections::Ended ended,
                    bool isStream);
    ~ExpectedChannel();
    ExpectedChannel(const ExpectedChannel&) = delete;
    ExpectedChannel& operator=(const ExpectedChannel&) = delete;

    /** For policy.name_id; empty for a stream. */
    const std::string& name() const { return name_; }

    struct Known {
        std::shared_ptr<const internal::ConnID> id;  // null if nothing is expected
        LostConnections::Ended ended;
    };
    /** The channel that this port expects: the one of that name, or the stream. */
    static Known of(const base::PortInterface& input, const std::string& name, bool isStream);

private:
    /** Null if there is none. With the lock. */
    static const ExpectedChannel* find(const base::PortInterface& input, const std::string& name);

    const base::PortInterface& input_;
    const Known known_;
    const std::string name_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
