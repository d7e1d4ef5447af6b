// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_LONE_SERVICE_HPP
#define ORO_CORBA_DETAIL_LONE_SERVICE_HPP

#include <rtt/transports/corba/ServiceC.h>
#include <rtt/transports/corba/detail/remote_peer.hpp>
#include <rtt/transports/corba/detail/watch.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace corba {
namespace detail {

/**
 * A service of another process of which only the reference is known, as the peer of all that stand for its operations.
 * It asks the service once a second whether it is still there. When the process has started again, a proxy of the
 * component in this process finds the new service.
 */
class LoneService final : public RemotePeer {
public:
    /** The one of that reference, which all users share. */
    static std::shared_ptr<LoneService> of(CService_ptr service, const std::string& name);
    LoneService(CService_ptr service, const std::string& name);

    const std::shared_ptr<RemoteReference>& reference() const { return reference_; }

private:
    void check();
    bool answers();
    bool isFoundAgain();
    void lookForProxy();

    const std::shared_ptr<RemoteReference> reference_;
    std::weak_ptr<RemoteReference> ofProxy_;  // the same service, as a proxy knows it
    const Watch watch_;                       // the last member: it uses the others
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
