// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/RemoteChannelElement.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/CorbaConnPolicy.hpp>
#include <rtt/transports/corba/RemoteConnID.hpp>
#include <rtt/transports/corba/detail/later.hpp>
#include <rtt/transports/corba/detail/remote_channel.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::corba {

CRemoteChannelElement_i::CRemoteChannelElement_i(CorbaTypeTransporter const& transporter, PortableServer::POA_ptr poa)
    : transport(transporter), mpoa(PortableServer::POA::_duplicate(poa)) {}

CRemoteChannelElement_i::~CRemoteChannelElement_i() = default;

CRemoteChannelElement_ptr CRemoteChannelElement_i::activate_this() {
    const PortableServer::ObjectId_var id = mpoa->activate_object(this);
    const CORBA::Object_var object = mpoa->id_to_reference(id);
    return corba::CRemoteChannelElement::_narrow(object);
}

void CRemoteChannelElement_i::setRemoteSide(CRemoteChannelElement_ptr remote) {
    remote_side = corba::CRemoteChannelElement::_duplicate(remote);
}

PortableServer::POA_ptr CRemoteChannelElement_i::_default_POA() { return PortableServer::POA::_duplicate(mpoa); }

namespace {

std::string ownerOf(DataFlowInterface* sender) {
    const TaskContext* const owner = sender ? sender->getOwner() : nullptr;
    return owner ? owner->getName() : "channel";
}

}  // namespace

ErasedRemoteChannelElement::ErasedRemoteChannelElement(CorbaTypeTransporter const& transporter,
                                                       const types::TypeInfo* type, DataFlowInterface* sender,
                                                       PortableServer::POA_ptr poa, const ConnPolicy& policy)
    : CRemoteChannelElement_i(transporter, poa), type_(type), policy_(policy), described_(ownerOf(sender)) {
    ref();
}

ErasedRemoteChannelElement::~ErasedRemoteChannelElement() = default;

ErasedRemoteChannelElement::Channel ErasedRemoteChannelElement::channel() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return channel_;
}

/** Null if there is one already, or if none can be made. */
ErasedRemoteChannelElement::Channel ErasedRemoteChannelElement::newChannel(bool isWriter) {
    typedef detail::RemoteChannel::End End;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (channel_ || left_) return nullptr;
    // The component may be gone by now, so that only the properties of the process count for the thread.
    channel_ = detail::RemoteChannel::make(isWriter ? End::Writer : End::Reader, *type_, policy_, described_, nullptr);
    if (channel_ && !CORBA::is_nil(remote_side)) channel_->setRemoteSide(remote_side);
    return channel_;
}

bool ErasedRemoteChannelElement::connectTo(shared_ptr const& output, bool mandatory) {
    const Channel before = newChannel(false);
    return before && before->connectTo(this) && ChannelElementBase::connectTo(output, mandatory);
}

bool ErasedRemoteChannelElement::connectFrom(shared_ptr const& input) {
    if (input == channel()) return ChannelElementBase::connectFrom(input);
    const Channel behind = newChannel(true);
    return behind && ChannelElementBase::connectFrom(input) && ChannelElementBase::connectTo(behind);
}

// Nobody calls this end any more. The helper does it, as the caller may hold a lock.
void ErasedRemoteChannelElement::deactivate() {
    if (left_.exchange(true)) return;
    const boost::intrusive_ptr<ErasedRemoteChannelElement> self(this);
    detail::later([self] {
        Channel own;
        {
            const std::lock_guard<std::mutex> lock(self->mutex_);
            own.swap(self->channel_);
        }
        const PortableServer::ObjectId_var id = self->mpoa->servant_to_id(self.get());
        self->mpoa->deactivate_object(id);
    });
}

bool ErasedRemoteChannelElement::disconnect(shared_ptr const& channel, bool forward) {
    deactivate();
    return ChannelElementBase::disconnect(channel, forward);
}

void ErasedRemoteChannelElement::disconnect(bool forward) {
    deactivate();
    ChannelElementBase::disconnect(forward);
}

void ErasedRemoteChannelElement::transferSamples() {
    if (const Channel own = channel()) (void)own->signal();
}

void ErasedRemoteChannelElement::setRemoteSide(CRemoteChannelElement_ptr remote) {
    const std::lock_guard<std::mutex> lock(mutex_);
    CRemoteChannelElement_i::setRemoteSide(remote);
    if (channel_) channel_->setRemoteSide(remote);
}

CORBA::Boolean ErasedRemoteChannelElement::channelReady(const CConnPolicy& policy) {
    const shared_ptr reader = getOutput();
    return reader &&
           reader->channelReady(this, toRTT(policy), new RemoteConnID(CDataFlowInterface::_nil(), getElementName()));
}

CFlowStatus ErasedRemoteChannelElement::read(CORBA::Any_OUT_arg sample, CORBA::Boolean copy_old_data) {
    CORBA::Any_var made = new CORBA::Any();
    const Channel own = channel();
    const CFlowStatus status = own ? own->read(made.inout(), copy_old_data) : CNoData;
    sample = made._retn();
    return status;
}

CWriteStatus ErasedRemoteChannelElement::write(const CORBA::Any& sample) {
    const Channel own = channel();
    return own ? own->received(sample) : CNotConnected;
}

void ErasedRemoteChannelElement::writeOneway(const CORBA::Any& sample) { (void)write(sample); }

void ErasedRemoteChannelElement::disconnect() {
    if (const Channel own = channel()) own->leave();
}

void ErasedRemoteChannelElement::remoteSignal() {
    if (const Channel own = channel()) own->signalled();
}

void ErasedRemoteChannelElement::remoteDisconnect(CORBA::Boolean) { disconnect(); }

}  // namespace RTT::corba
