// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REMOTE_PEER_HPP
#define ORO_CORBA_DETAIL_REMOTE_PEER_HPP

#include <rtt/transports/corba/corba.h>

#include <rtt/transports/corba/detail/remote_reference.hpp>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace RTT {
namespace corba {
namespace detail {

/** A component of another process, as all that stand for its parts know it. Any thread may use it. */
class RemotePeer {
public:
    /** `isWatched`: somebody calls found() when it answers again. */
    explicit RemotePeer(std::string name, bool isWatched = false) : name_(std::move(name)), isWatched_(isWatched) {}

    const std::string& name() const { return name_; }
    /** A call failed, which is logged; a watched peer may be lost. */
    void failed(const CORBA::Exception& error);
    /** It answers again. */
    void found();
    /** It did not answer, so that nobody else should wait for it. */
    bool isLost() const { return lost_.load(std::memory_order_acquire); }

    /** By its path, "" for the root, "a.b" for a service of a service. */
    std::shared_ptr<RemoteReference> service(const std::string& path);

private:
    const std::string name_;
    const bool isWatched_;
    std::atomic<bool> lost_{false};
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<RemoteReference>> services_;
};

/** "COMM_FAILURE", with what that means. */
std::string describe(const CORBA::Exception& error);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
