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
    /** A proxy or a LoneService watches the other component, and calls found() when that answers again. */
    explicit RemotePeer(std::string name) : name_(std::move(name)) {}

    const std::string& name() const { return name_; }
    /** A call failed, which is logged. The first one that is not answered, too: from then on the peer is lost. */
    void failed(const CORBA::Exception& error);
    /** It answers again. */
    void found();
    /** It did not answer, so that nobody else should wait for it. */
    bool isLost() const { return lost_.load(std::memory_order_acquire); }

    /** By its path, "" for the root, "a.b" for a service of a service. */
    std::shared_ptr<RemoteReference> service(const std::string& path);
    /** By its present reference; null if it has none. */
    std::shared_ptr<RemoteReference> service(CService_ptr reference) const;

private:
    const std::string name_;
    std::atomic<bool> lost_{false};
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<RemoteReference>> services_;
};

/** From now on proxied() finds the services of this component, which a proxy of this process stands for. */
void addProxied(const std::shared_ptr<RemotePeer>& peer);
/** A service of one of these components; null if there is none with that reference. */
std::shared_ptr<RemoteReference> proxied(CService_ptr service);

/** "COMM_FAILURE", with what that means. */
std::string describe(const CORBA::Exception& error);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
