// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/send_channel.hpp>

#include <rtt/Logger.hpp>
#include <rtt/os/priority_lock.hpp>

#include <cerrno>
#include <cstring>
#include <utility>

namespace RTT::mqueue::detail {

using os::detail::PriorityLock;

SendChannel::SendChannel(std::unique_ptr<Queue> queue, std::unique_ptr<MessageFormat> format, bool keepsOldest,
                         std::string described)
    : queue_(std::move(queue)),
      format_(std::move(format)),
      keepsOldest_(keepsOldest),
      described_(std::move(described)),
      message_(static_cast<std::size_t>(queue_->size().bytes)),
      first_(message_.size()),
      dropped_(message_.size()) {}

SendChannel::~SendChannel() { unlink(); }

// What a process that has ended left in the queue must not keep receivers from the first message of a stream. Later,
// when the port is given another sample of the largest size, samples that wait for the receiver are worth more.
WriteStatus SendChannel::sampleErased(const void* sample, bool) {
    const PriorityLock lock(busy_);
    const std::size_t size = format_->write(sample, message_.data(), message_.size());
    if (size == 0) return refuse(sample);
    const Message message{message_.data(), size, kFirstPriority};
    if (!std::exchange(begun_, true)) return postInsteadOfOldest(message);
    (void)post(message);
    return WriteSuccess;
}

bool SendChannel::disconnect(shared_ptr const& channel, bool forward) {
    unlink();
    return base::ChannelElementBase::disconnect(channel, forward);
}

// At most once, because another stream may have a queue of that name later.
void SendChannel::unlink() {
    if (linked_.exchange(false)) queue_->unlink();
}

WriteStatus SendChannel::send(const void* sample) {
    if (format_->isMemory()) {
        const Message message{sample, format_->sizeOf(sample), 0};
        const WriteStatus status = post(message);
        if (status == WriteSuccess || keepsOldest_) return status;
        const PriorityLock lock(busy_);
        return postInsteadOfOldest(message);
    }
    const PriorityLock lock(busy_);
    const std::size_t size = format_->write(sample, message_.data(), message_.size());
    if (size == 0) return refuse(sample);
    const Message message{message_.data(), size, 0};
    return keepsOldest_ ? post(message) : postInsteadOfOldest(message);
}

WriteStatus SendChannel::post(const Message& message) {
    const int error = queue_->send(message.at, message.size, message.priority);
    if (error == 0 || error == EAGAIN) {
        reported_.store(0, std::memory_order_relaxed);
        return error == 0 ? WriteSuccess : WriteFailure;
    }
    if (reported_.exchange(error) != error)
        log(Error) << described_ << ": could not write to queue '" << queue_->name() << "': " << std::strerror(error)
                   << endlog();
    return WriteFailure;
}

// A receiver may take messages at the same time, and other senders may add some, so that takes a few attempts.
WriteStatus SendChannel::postInsteadOfOldest(const Message& message) {
    WriteStatus status = post(message);
    for (long attempt = queue_->size().messages; status == WriteFailure && attempt != 0; --attempt) {
        if (reported_.load(std::memory_order_relaxed) != 0) break;
        dropOldest();
        status = post(message);
    }
    return status;
}

void SendChannel::dropOldest() {
    unsigned priority = 0;
    const long size = queue_->receive(first_.data(), priority);
    if (size < 0 || priority < kFirstPriority) return;
    // That was the first message, for which a receiver will wait.
    (void)queue_->receive(dropped_.data(), priority);
    (void)queue_->send(first_.data(), static_cast<std::size_t>(size), kFirstPriority);
}

WriteStatus SendChannel::refuse(const void* sample) {
    const std::size_t size = format_->sizeOf(sample);
    if (reported_.exchange(EMSGSIZE) == EMSGSIZE) return WriteFailure;
    if (size == 0)
        log(Error) << described_ << ": a sample cannot be encoded, so it does not get into queue '" << queue_->name()
                   << "'" << endlog();
    else
        log(Error) << described_ << ": a sample needs a message of " << size << " bytes, and those of queue '"
                   << queue_->name() << "' have " << queue_->size().bytes
                   << "; before you create the stream, set policy.data_size, or give the port its largest sample with "
                      "setDataSample()"
                   << endlog();
    return WriteFailure;
}

}  // namespace RTT::mqueue::detail
