// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_LOST_CONNECTIONS_HPP
#define ORO_CORBA_DETAIL_LOST_CONNECTIONS_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/PortInterface.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace RTT {
namespace corba {
namespace detail {

/** The connections of a port of another process that ended with that process. Any thread may use it. */
class LostConnections : public std::enable_shared_from_this<LostConnections> {
public:
    /** What a channel calls when it ends: true if the other process is gone, false if that has disconnected it, which
        it also does before it ends. */
    typedef std::function<void(bool isGone)> Ended;
    /** Remembers the connection with a port of this process when it ends. Empty if the port belongs to no component. */
    Ended remember(const base::PortInterface& port, const ConnPolicy& policy);

    /** The other process has ended: what it disconnected shortly before is lost, too. */
    void ended();
    /** Connects again, by `connect`, what has been lost. */
    void restore(const std::function<bool(base::PortInterface& port, const ConnPolicy& policy)>& connect);

private:
    struct Lost {
        std::function<bool(const std::function<void(base::PortInterface&)>&)> withPort;  // false if the port is gone
        ConnPolicy policy;
        bool isGone;
        std::chrono::steady_clock::time_point since;
        int tries;
    };
    std::vector<Lost> take();

    std::mutex mutex_;
    std::vector<Lost> all_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
