// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/receive_channel.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/fosi.h>
#include <rtt/transports/mqueue/detail/dispatcher.hpp>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <unistd.h>
#include <utility>

namespace RTT::mqueue::detail {

namespace {

constexpr int kPatience = 500;      // ms
constexpr useconds_t kLook = 2000;  // us, between two looks for a queue that is not there

}  // namespace

/** For some time that begins now. */
class ReceiveChannel::Patience {
public:
    int left() const {
        const std::int64_t ms = (end_ - rtos_get_time_ns()) / 1000000;
        return ms > 0 ? static_cast<int>(ms) : 0;
    }

private:
    const std::int64_t end_ = rtos_get_time_ns() + kPatience * 1000000LL;
};

ReceiveChannel::ReceiveChannel(std::string queue, std::unique_ptr<MessageFormat> format,
                               base::DataSourceBase::shared_ptr sample, bool waits, std::string described)
    : name_(std::move(queue)),
      format_(std::move(format)),
      sample_(std::move(sample)),
      waits_(waits),
      described_(std::move(described)) {}

bool ReceiveChannel::inputReady() {
    if (started_) return true;
    const Patience patience;
    std::string why;
    while (!findQueue(why) && why.empty() && patience.left() != 0) usleep(kLook);
    if (!queue_) {
        if (why.empty())
            why =
                "there is none within " + std::to_string(kPatience) + " ms; create the stream of the output port first";
        log(Error) << described_ << ": queue '" << name_ << "' cannot be used: " << why << endlog();
        return false;
    }
    if (!waitForFirst(patience))
        log(Info) << described_ << ": no message came through queue '" << name_ << "' within " << kPatience
                  << " ms; its sender may be waiting, or have ended" << endlog();
    {
        const os::MutexLock lock(mutex_);
        started_ = true;
    }
    Dispatcher::instance().add(*this);
    return true;
}

bool ReceiveChannel::findQueue(std::string& why) {
    queue_ = Queue::find(name_, why);
    if (!queue_) return false;
    const std::size_t least = format_->hasFixedSize() ? format_->sizeOf(sample_->getRawConstPointer()) : 0;
    if (static_cast<std::size_t>(queue_->size().bytes) < least) {
        why = "its messages have " + std::to_string(queue_->size().bytes) + " bytes, and a sample has " +
              std::to_string(least);
        queue_.reset();
        return false;
    }
    message_.resize(static_cast<std::size_t>(queue_->size().bytes));
    return true;
}

/** The first message shows the size of samples, so the storage gets it. */
bool ReceiveChannel::waitForFirst(const Patience& patience) {
    while (queue_->waitForMessage(patience.left())) {
        const Taken taken = take();
        if (taken == Taken::First || taken == Taken::Sample) {
            (void)base::ChannelElementBase::sampleErased(sample_->getRawConstPointer(), true);
            // A sender that was there before this receiver has sent its first message to an earlier one.
            if (taken == Taken::Sample && !format_->isOfOriginal()) deliver();
            return true;
        }
        // Another receiver was faster, or somebody has left a message that is no sample.
        if (patience.left() == 0) return false;
    }
    return false;
}

bool ReceiveChannel::disconnect(shared_ptr const& channel, bool forward) {
    bool wasStarted = false;
    {
        const os::MutexLock lock(mutex_);
        wasStarted = std::exchange(started_, false);
    }
    if (wasStarted) Dispatcher::instance().remove(*this);
    return base::ChannelElementBase::disconnect(channel, forward);
}

void ReceiveChannel::receive() {
    if (heldUp_) return deliver();
    Taken taken = Taken::None;
    {
        const os::MutexLock lock(mutex_);
        if (started_) taken = take();
    }
    if (taken == Taken::Sample) deliver();
    if (taken == Taken::First) (void)base::ChannelElementBase::sampleErased(sample_->getRawConstPointer(), false);
}

ReceiveChannel::Taken ReceiveChannel::take() {
    unsigned priority = 0;
    const long size = queue_->receive(message_.data(), priority);
    if (size == -1) {
        if (errno == EAGAIN) return Taken::None;
        refuse(std::strerror(errno));
        return Taken::Bad;
    }
    std::string why;
    if (format_->read(message_.data(), static_cast<std::size_t>(size), sample_->getRawPointer(), why)) {
        complained_ = false;
        return priority >= kFirstPriority ? Taken::First : Taken::Sample;
    }
    refuse(why);
    return Taken::Bad;
}

void ReceiveChannel::deliver() {
    const internal::Reclaimer::Guard guard;
    base::ChannelElementBase* const storage = outputUnderGuard();
    heldUp_ = storage && storage->writeErased(sample_->getRawConstPointer()) == WriteFailure && waits_;
}

void ReceiveChannel::refuse(const std::string& why) {
    if (!std::exchange(complained_, true))
        log(Error) << described_ << ": a message of queue '" << name_ << "' is ignored: " << why << endlog();
}

bool ReceiveChannel::followQueue() {
    std::string why;
    std::unique_ptr<Queue> other = Queue::find(name_, why);
    if (!other || other->isSame(*queue_)) return false;
    for (long left = queue_->size().messages; left != 0 && !heldUp_; --left) receive();
    message_.resize(static_cast<std::size_t>(other->size().bytes));
    queue_ = std::move(other);
    log(Info) << described_ << ": queue '" << name_ << "' was made anew; its messages are received from now on"
              << endlog();
    return true;
}

}  // namespace RTT::mqueue::detail
