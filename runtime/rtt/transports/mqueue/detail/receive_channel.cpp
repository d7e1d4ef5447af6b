// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/receive_channel.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/transports/mqueue/detail/dispatcher.hpp>

#include <cerrno>
#include <cstring>
#include <utility>

namespace RTT::mqueue::detail {

namespace {
constexpr int kPatience = 500;  // ms
}

ReceiveChannel::ReceiveChannel(std::unique_ptr<Queue> queue, std::unique_ptr<MessageFormat> format,
                               base::DataSourceBase::shared_ptr sample, std::string described)
    : name_(queue->name()),
      queue_(std::move(queue)),
      format_(std::move(format)),
      sample_(std::move(sample)),
      described_(std::move(described)),
      message_(static_cast<std::size_t>(queue_->size().bytes)) {}

bool ReceiveChannel::inputReady() {
    if (started_) return true;
    if (!queue_->waitForMessage(kPatience)) {
        if (queue_->isNew()) queue_->unlink();
        log(Error) << described_ << ": no message came through queue '" << name_ << "' within " << kPatience
                   << " ms; create the stream of the output port first" << endlog();
        return false;
    }
    const Taken taken = take();
    if (taken == Taken::None || taken == Taken::Bad) return false;
    // What it shows is the size of samples, so the storage gets it either way.
    (void)base::ChannelElementBase::sampleErased(sample_->getRawConstPointer(), true);
    // A sender that was there before this receiver has sent its first message to an earlier one.
    if (taken == Taken::Sample && !format_->isOfOriginal()) deliver();
    started_ = true;
    Dispatcher::instance().add(*this);
    return true;
}

bool ReceiveChannel::disconnect(shared_ptr const& channel, bool forward) {
    if (started_.exchange(false)) Dispatcher::instance().remove(*this);
    return base::ChannelElementBase::disconnect(channel, forward);
}

void ReceiveChannel::receive() {
    switch (take()) {
        case Taken::Sample: return deliver();
        case Taken::First: (void)base::ChannelElementBase::sampleErased(sample_->getRawConstPointer(), false); return;
        case Taken::None:
        case Taken::Bad: return;
    }
}

ReceiveChannel::Taken ReceiveChannel::take() {
    unsigned priority = 0;
    const long size = queue_->receive(message_.data(), priority);
    if (size == -1) {
        if (errno != EAGAIN) refuse(std::strerror(errno));
        return errno == EAGAIN ? Taken::None : Taken::Bad;
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
    if (base::ChannelElementBase* const storage = outputUnderGuard())
        (void)storage->writeErased(sample_->getRawConstPointer());
}

void ReceiveChannel::refuse(const std::string& why) {
    if (!std::exchange(complained_, true))
        log(Error) << described_ << ": a message of queue '" << name_ << "' is ignored: " << why << endlog();
}

void ReceiveChannel::exchangeQueue(std::unique_ptr<Queue> queue) {
    for (long left = queue_->size().messages; left != 0; --left) receive();
    message_.resize(static_cast<std::size_t>(queue->size().bytes));
    queue_ = std::move(queue);
}

}  // namespace RTT::mqueue::detail
