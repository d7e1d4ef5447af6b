// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REMOTE_PART_HPP
#define ORO_CORBA_DETAIL_REMOTE_PART_HPP

#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/transports/corba/OperationInterfaceC.h>
#include <rtt/transports/corba/detail/remote_peer.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace corba {
namespace detail {

/** What all that call one operation of another process share. */
struct RemoteOperation {
    std::shared_ptr<RemotePeer> peer;
    std::shared_ptr<const RemoteReference> service;
    std::string name, description;
    internal::OperationSignature signature;

    enum Patience { Limited, Unlimited };
    /** To call it. Throws std::runtime_error if the peer does not answer at present. */
    CService_var reachable(Patience patience) const;
    /** Throws what a call of this process would throw. */
    [[noreturn]] void fail(const CORBA::Exception& error) const;
};

/** An operation of another process. */
class RemotePart final : public internal::SignedPart {
public:
    RemotePart(std::shared_ptr<RemotePeer> peer, std::shared_ptr<const RemoteReference> service,
               const COperation& described);

    /** The service that has it; the caller owns the reference. */
    CService_var service() const { return operation_->service->get(); }
    /** It is the same operation. */
    bool is(const COperation& described) const;
    std::string getName() const override { return operation_->name; }
    std::string description() const override { return operation_->description; }
    internal::OperationSignature signature() const override { return operation_->signature; }

    base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceHandle() const override;
    base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const override;

private:
    std::shared_ptr<const RemoteOperation> operation_;
    std::string form_;  // the types, to tell it from another operation
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
