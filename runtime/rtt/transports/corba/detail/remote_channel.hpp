// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REMOTE_CHANNEL_HPP
#define ORO_CORBA_DETAIL_REMOTE_CHANNEL_HPP

#include <rtt/Activity.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/transports/corba/DataFlowC.h>
#include <rtt/transports/corba/corba.h>
#include <rtt/transports/corba/detail/lost_connections.hpp>
#include <rtt/transports/corba/detail/watch.hpp>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace RTT {
namespace types {
class TypeInfo;
struct TypeOps;
}  // namespace types
namespace corba {

class CorbaTypeTransporter;

namespace detail {

/**
 * The end of a connection in this process, whose other end is in another one.
 *
 *   writer's process:  OutputPort -> [storage] -> [RemoteChannel]
 *   reader's process:  [RemoteChannel] -> [storage, unless the reader pulls] -> InputPort
 *
 * A writer only wakes the thread of its channel, which takes the samples out of the storage and writes them (push), or
 * tells the reader that they are there (pull). So another process that is slow, stopped or gone delays nobody.
 *
 * If the samples cross by another transport, the channels stand beyond the elements of that one. They have no thread,
 * and only see to it that both ends end together.
 */
class RemoteChannel final : public base::ChannelElementBase {
public:
    typedef boost::intrusive_ptr<RemoteChannel> Pointer;
    enum class End { Writer, Reader };

    /** What the other end asks for when both ends know each other; false refuses the connection. */
    typedef std::function<bool()> Ready;

    /** Null, with an error logged, if values of the type do not cross CORBA. `described`: the port, for messages. */
    static Pointer make(End end, const types::TypeInfo& type, const ConnPolicy& policy, std::string described);
    ~RemoteChannel() override;

    /** By which the other process calls this end. The caller owns the reference. */
    CRemoteChannelElement_ptr reference() const { return CRemoteChannelElement::_duplicate(reference_); }
    void setRemoteSide(CRemoteChannelElement_ptr other);
    void whenReady(Ready ready) { ready_ = std::move(ready); }
    void whenEnded(LostConnections::Ended ended);

    // From the port's side.
    bool signal() override;
    FlowStatus readErased(void* sample, bool copyOld) override;
    WriteStatus sampleErased(const void*, bool) override { return WriteSuccess; }
    using base::ChannelElementBase::inputReady;
    bool inputReady() override { return true; }
    using base::ChannelElementBase::disconnect;
    bool disconnect(shared_ptr const& channel, bool forward) override;
    bool isRemoteElement() const override { return true; }
    std::string getElementName() const override { return "CorbaRemoteChannelElement"; }

    // From the other process.
    CWriteStatus received(const CORBA::Any& sample);
    CFlowStatus read(CORBA::Any& sample, bool copyOld);
    void signalled();
    bool isReady();
    /** The other end has left, or asks this one to leave. */
    void leave() { end(false); }

private:
    class Servant;
    class Sender;
    RemoteChannel(End end, const types::TypeInfo& type, const CorbaTypeTransporter& transporter,
                  const ConnPolicy& policy, std::string described);
    void activate();
    void deactivate();
    CRemoteChannelElement_var remote() const;
    void sendAll();
    bool isSent(CRemoteChannelElement_ptr other);
    bool fail(const CORBA::Exception& error);
    void end(bool isGone);
    void watchOther();
    void breakChain();

    const End end_;
    const bool pull_;
    const CorbaTypeTransporter& transporter_;
    const types::TypeOps& ops_;
    const std::string described_;
    const base::DataSourceBase::shared_ptr sample_;  // of the thread that holds sampleMutex_
    std::mutex sampleMutex_;
    mutable std::mutex remoteMutex_;  // guards remote_, servant_, reference_, ready_, ended_
    CRemoteChannelElement_var remote_;
    PortableServer::ServantBase* servant_ = nullptr;
    CRemoteChannelElement_var reference_;
    std::unique_ptr<Activity> sender_;  // of a writer whose samples cross here
    std::unique_ptr<Watch> watch_;      // notices the end of the other process while no sample comes or goes
    Ready ready_;
    LostConnections::Ended ended_;
    std::atomic<bool> reached_{false};   // the other end has answered
    std::atomic<bool> hangs_{false};     // it did not in time; nobody waits for it until it answers the watch
    std::atomic<bool> reported_{false};  // that, or a sample that cannot be sent
    std::atomic<bool> refused_{false};   // that the reader does not take samples
    std::atomic<bool> left_{false};
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
