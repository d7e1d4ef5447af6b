// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/remote_channel.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/transports/corba/ApplicationServer.hpp>
#include <rtt/transports/corba/CorbaTypeTransporter.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/transports/corba/detail/later.hpp>
#include <rtt/transports/corba/detail/policies.hpp>
#include <rtt/transports/corba/detail/remote_peer.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeOps.hpp>

#include <omniORB4/omniORB.h>

#include <exception>
#include <string>
#include <utility>

namespace RTT::corba::detail {

namespace {
constexpr CORBA::ULong kPatience = 2000;  // ms, for one sample
}  // namespace

/** The object that the other process calls. */
class RemoteChannel::Servant final : public POA_RTT::corba::CRemoteChannelElement {
public:
    explicit Servant(RemoteChannel& channel) : channel_(&channel) {}

    CORBA::Boolean inputReady() override { return true; }
    CORBA::Boolean channelReady(const CConnPolicy&) override { return channel_->isReady(); }
    CFlowStatus read(CORBA::Any_OUT_arg sample, CORBA::Boolean copy_old_data) override {
        CORBA::Any_var made = new CORBA::Any();
        const CFlowStatus status = channel_->read(made.inout(), copy_old_data);
        sample = made._retn();
        return status;
    }
    CWriteStatus write(const CORBA::Any& sample) override { return channel_->received(sample); }
    void writeOneway(const CORBA::Any& sample) override { (void)channel_->received(sample); }
    void disconnect() override { channel_->leave(); }
    void setRemoteSide(CRemoteChannelElement_ptr other) override { channel_->setRemoteSide(other); }
    void remoteSignal() override { channel_->signalled(); }
    void remoteDisconnect(CORBA::Boolean) override { channel_->leave(); }

private:
    const RemoteChannel::Pointer channel_;
};

/** The thread of a writer's channel. */
class RemoteChannel::Sender final : public Activity {
public:
    Sender(RemoteChannel& channel, const std::string& name) : Activity(nullptr, name), channel_(channel) {
        setStopTimeout(2 * kPatience / 1000.0);
        (void)start();
    }

protected:
    void loop() override { channel_.sendAll(); }
    bool breakLoop() override { return true; }

private:
    RemoteChannel& channel_;
};

RemoteChannel::Pointer RemoteChannel::make(End end, const types::TypeInfo& type, const ConnPolicy& policy,
                                           std::string described) {
    const CorbaTypeTransporter* const transporter = transporterOf(type);
    if (!transporter) {
        log(Error) << described << ": values of type " << type.getTypeName()
                   << " do not cross CORBA; import the package of the type" << endlog();
        return nullptr;
    }
    const Pointer made(new RemoteChannel(end, type, *transporter, policy, std::move(described)));
    made->activate();
    return made;
}

RemoteChannel::RemoteChannel(End end, const types::TypeInfo& type, const CorbaTypeTransporter& transporter,
                             const ConnPolicy& policy, std::string described)
    : end_(end),
      pull_(policy.pull),
      transporter_(transporter),
      ops_(*type.getOps()),
      described_(std::move(described)),
      sample_(type.buildValue()) {
    if (end == End::Writer && !isOutOfBand(policy))
        sender_ = std::make_unique<Sender>(*this, described_.substr(0, described_.find('.')) + "Corba");
}

RemoteChannel::~RemoteChannel() = default;

void RemoteChannel::activate() {
    watch_ = std::make_unique<Watch>([this] { watchOther(); });
    const PortableServer::ServantBase_var owned(servant_ = new Servant(*this));
    const PortableServer::ObjectId_var id = ApplicationServer::rootPOA->activate_object(servant_);
    const CORBA::Object_var object = ApplicationServer::rootPOA->id_to_reference(id);
    reference_ = CRemoteChannelElement::_narrow(object);
}

// The servant holds this object, so the sender has ended before that is destroyed. Only for the helper's thread.
void RemoteChannel::deactivate() {
    watch_.reset();
    if (sender_) (void)sender_->stop();
    PortableServer::ServantBase* servant = nullptr;
    Ready unused;
    {
        const std::lock_guard<std::mutex> lock(remoteMutex_);
        unused.swap(ready_);
        servant = std::exchange(servant_, nullptr);
        remote_ = CRemoteChannelElement::_nil();
    }
    if (!servant) return;
    const PortableServer::ObjectId_var id = ApplicationServer::rootPOA->servant_to_id(servant);
    ApplicationServer::rootPOA->deactivate_object(id);
}

void RemoteChannel::setRemoteSide(CRemoteChannelElement_ptr other) {
    if (!CORBA::is_nil(other)) omniORB::setClientCallTimeout(other, kPatience);
    const std::lock_guard<std::mutex> lock(remoteMutex_);
    remote_ = CRemoteChannelElement::_duplicate(other);
}

CRemoteChannelElement_var RemoteChannel::remote() const {
    const std::lock_guard<std::mutex> lock(remoteMutex_);
    return remote_;
}

// The function may hold this channel, so it is given up.
bool RemoteChannel::isReady() {
    Ready ready;
    {
        const std::lock_guard<std::mutex> lock(remoteMutex_);
        ready.swap(ready_);
    }
    return !ready || ready();
}

void RemoteChannel::whenEnded(LostConnections::Ended ended) {
    if (ended) reached_ = true;  // by the proxy that has asked for this connection
    const std::lock_guard<std::mutex> lock(remoteMutex_);
    ended_ = std::move(ended);
}

bool RemoteChannel::signal() {
    if (end_ == End::Reader) return base::ChannelElementBase::signal();
    return !sender_ || sender_->trigger();
}

FlowStatus RemoteChannel::readErased(void* sample, bool copyOld) {
    const CRemoteChannelElement_var other = remote();
    if (CORBA::is_nil(other) || hangs_) return NoData;
    try {
        CORBA::Any_var any;
        const auto status = static_cast<FlowStatus>(other->read(any.out(), copyOld));
        reached_ = true;
        if (status == NoData || (status == OldData && !copyOld)) return status;
        const std::lock_guard<std::mutex> lock(sampleMutex_);
        if (!transporter_.updateFromAny(&any.in(), sample_)) return NoData;
        ops_.assign(sample, sample_->getRawConstPointer());
        return status;
    } catch (const CORBA::Exception& error) {
        (void)fail(error);
        return NoData;
    }
}

// Takes the samples out one by one, so that a signal that comes meanwhile starts another round.
void RemoteChannel::sendAll() {
    for (;;) {
        const CRemoteChannelElement_var other = remote();
        if (CORBA::is_nil(other) || hangs_) return;
        try {
            if (!isSent(other)) return;
            reached_ = true;
        } catch (const CORBA::Exception& error) {
            if (!fail(error)) return;
        } catch (const std::exception& thrown) {
            if (!reported_.exchange(true))
                log(Error) << described_ << ": a sample cannot be sent: " << thrown.what() << endlog();
        }
    }
}

/** False if there is nothing more to send. */
bool RemoteChannel::isSent(CRemoteChannelElement_ptr other) {
    if (pull_) {
        other->remoteSignal();
        return false;
    }
    CORBA::Any any;
    {
        const internal::Reclaimer::Guard guard;
        const std::lock_guard<std::mutex> lock(sampleMutex_);
        base::ChannelElementBase* const storage = inputUnderGuard();
        if (!storage || storage->readErased(sample_->getRawPointer(), false) != NewData) return false;
        if (!transporter_.updateAny(sample_, any)) {
            if (!reported_.exchange(true)) log(Error) << described_ << ": a sample cannot be encoded" << endlog();
            return true;
        }
    }
    const CWriteStatus status = other->write(any);
    if (status == CNotConnected) leave();
    if (status == CWriteFailure && !refused_.exchange(true))
        log(Warning) << described_ << ": the reader in another process does not take every sample" << endlog();
    return status != CNotConnected;
}

/** True if the next sample may fare better. */
bool RemoteChannel::fail(const CORBA::Exception& error) {
    const bool isGone = CORBA::OBJECT_NOT_EXIST::_downcast(&error) || CORBA::OBJ_ADAPTER::_downcast(&error);
    const bool hangs = CORBA::TIMEOUT::_downcast(&error) != nullptr;
    const bool isLost = isGone || CORBA::COMM_FAILURE::_downcast(&error) || CORBA::TRANSIENT::_downcast(&error) ||
                        CORBA::INV_OBJREF::_downcast(&error);
    if (hangs) hangs_ = true;
    if (!isGone && !reported_.exchange(true))  // one that has left just did not tell yet
        log(Error) << described_ << ": "
                   << (hangs    ? "the other process does not answer (TIMEOUT), samples are lost"
                       : isLost ? "the other process does not answer (" + std::string(error._name()) +
                                      "), the connection ends"
                                : "a sample does not cross (" + describe(error) + ")")
                   << endlog();
    if (isLost) end(true);
    return !isLost && !hangs;
}

// One that never could be reached may have an address of its own network only: it can write all the same.
void RemoteChannel::watchOther() {
    const CRemoteChannelElement_var other = remote();
    if (CORBA::is_nil(other)) return;
    try {
        (void)other->inputReady();
        reached_ = true;
        if (!hangs_.exchange(false)) return;
        reported_ = false;
        if (sender_) (void)sender_->trigger();  // for the samples that wait
    } catch (const CORBA::TRANSIENT& error) {
        if (reached_ || end_ == End::Writer) (void)fail(error);
    } catch (const CORBA::Exception& error) {
        (void)fail(error);
    }
}

CWriteStatus RemoteChannel::received(const CORBA::Any& sample) {
    const internal::Reclaimer::Guard guard;  // components are woken when it ends, without the lock
    const std::lock_guard<std::mutex> lock(sampleMutex_);
    if (!transporter_.updateFromAny(&sample, sample_)) return CWriteFailure;
    base::ChannelElementBase* const next = outputUnderGuard();
    return next ? static_cast<CWriteStatus>(next->writeErased(sample_->getRawConstPointer())) : CNotConnected;
}

CFlowStatus RemoteChannel::read(CORBA::Any& sample, bool copyOld) {
    const std::lock_guard<std::mutex> lock(sampleMutex_);
    FlowStatus status = NoData;
    {
        const internal::Reclaimer::Guard guard;
        base::ChannelElementBase* const storage = inputUnderGuard();
        if (storage) status = storage->readErased(sample_->getRawPointer(), copyOld);
    }
    if (status == NewData || (status == OldData && copyOld)) (void)transporter_.updateAny(sample_, sample);
    return static_cast<CFlowStatus>(status);
}

void RemoteChannel::signalled() { (void)base::ChannelElementBase::signal(); }

// The port that breaks the chain may hold a lock, so the other process is called later.
bool RemoteChannel::disconnect(shared_ptr const& channel, bool forward) {
    if (!left_.exchange(true)) {
        const Pointer self(this);
        later([self] {
            const CRemoteChannelElement_var other = self->hangs_ ? CRemoteChannelElement_var() : self->remote();
            try {
                if (!CORBA::is_nil(other)) other->remoteDisconnect(self->end_ == End::Writer);
            } catch (const CORBA::Exception&) {
                // It is gone, or notices that the object is.
            }
            self->deactivate();
        });
    }
    return base::ChannelElementBase::disconnect(channel, forward);
}

void RemoteChannel::end(bool isGone) {
    if (left_.exchange(true)) return;
    LostConnections::Ended ended;
    {
        const std::lock_guard<std::mutex> lock(remoteMutex_);
        ended.swap(ended_);
    }
    if (ended) ended(isGone);
    const Pointer self(this);
    later([self] {
        self->deactivate();
        self->breakChain();
    });
}

void RemoteChannel::breakChain() { (void)base::ChannelElementBase::disconnect(nullptr, end_ == End::Reader); }

}  // namespace RTT::corba::detail
