// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_REMOTE_CHANNEL_ELEMENT_HPP
#define ORO_CORBA_REMOTE_CHANNEL_ELEMENT_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/transports/corba/DataFlowI.h>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <atomic>
#include <mutex>
#include <string>

namespace RTT {
class DataFlowInterface;
namespace types {
class TypeInfo;
}
namespace corba {
namespace detail {
class RemoteChannel;
}

/** What is the same for all types of samples. */
class RTT_API ErasedRemoteChannelElement : public CRemoteChannelElement_i, public base::ChannelElementBase {
public:
    ErasedRemoteChannelElement(CorbaTypeTransporter const& transporter, const types::TypeInfo* type,
                               DataFlowInterface* sender, PortableServer::POA_ptr poa, const ConnPolicy& policy);
    ~ErasedRemoteChannelElement() override;

    // Both count the same references.
    void _add_ref() override { ref(); }
    void _remove_ref() override { deref(); }

    // From this process. What stands before it is the writer's side, what stands behind it the reader's.
    bool connectTo(shared_ptr const& output, bool mandatory = true) override;
    bool connectFrom(shared_ptr const& input) override;
    using base::ChannelElementBase::channelReady;
    bool disconnect(shared_ptr const& channel, bool forward) override;
    void disconnect(bool forward) override;
    bool isRemoteElement() const override { return true; }
    std::string getElementName() const override { return "CorbaRemoteChannelElement"; }
    void transferSamples() override;

    // From the other process.
    void setRemoteSide(CRemoteChannelElement_ptr remote) override;
    using base::ChannelElementBase::inputReady;
    CORBA::Boolean inputReady() override { return true; }
    CORBA::Boolean channelReady(const CConnPolicy& policy) override;
    CFlowStatus read(CORBA::Any_OUT_arg sample, CORBA::Boolean copy_old_data) override;
    CWriteStatus write(const CORBA::Any& sample) override;
    void writeOneway(const CORBA::Any& sample) override;
    void disconnect() override;
    void remoteSignal() override;
    void remoteDisconnect(CORBA::Boolean forward) override;

private:
    typedef boost::intrusive_ptr<detail::RemoteChannel> Channel;
    Channel channel() const;
    Channel newChannel(bool isWriter);
    void deactivate();

    const types::TypeInfo* const type_;
    const ConnPolicy policy_;
    const std::string described_;
    mutable std::mutex mutex_;  // guards channel_ and remote_side
    Channel channel_;
    std::atomic<bool> left_{false};
};

/**
 * The end of a channel in this process, whose other end is in another one: behind the storage of a writer, or before
 * that of a reader. A thread of its own sends the samples, so writers are not delayed. The library makes its channels
 * itself; this one is for those who connect ports by other means.
 *
 * Create it with new, call activate_this() and give the result to the other end, which gives its own to
 * setRemoteSide(). Then connect it, which logs an error and fails if values of T do not cross CORBA. Connect and
 * disconnect it in one thread; the rest may be called by any thread. read() of a connection that pulls calls the other
 * process and blocks.
 */
template <typename T>
class RemoteChannelElement : public ErasedRemoteChannelElement {
public:
    RemoteChannelElement(CorbaTypeTransporter const& transporter, DataFlowInterface* sender,
                         PortableServer::POA_ptr poa, const ConnPolicy& policy)
        : ErasedRemoteChannelElement(transporter, internal::DataSource<T>::GetTypeInfo(), sender, poa, policy) {}
};

}  // namespace corba
}  // namespace RTT

#endif
