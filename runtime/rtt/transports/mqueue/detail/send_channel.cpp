// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/send_channel.hpp>

#include <rtt/Logger.hpp>
#include <rtt/os/priority_lock.hpp>

#include <cerrno>
#include <cstring>
#include <utility>

namespace RTT::mqueue::detail {

SendChannel::SendChannel(std::unique_ptr<Queue> queue, std::unique_ptr<MessageFormat> format, bool keepsOldest,
                         std::string described)
    : queue_(std::move(queue)),
      format_(std::move(format)),
      keepsOldest_(keepsOldest),
      described_(std::move(described)),
      message_(static_cast<std::size_t>(queue_->size().bytes)),
      oldest_(message_.size()) {}

SendChannel::~SendChannel() { unlink(); }

WriteStatus SendChannel::sampleErased(const void* sample, bool) {
    // What a process that has ended left in the queue must not keep receivers from this.
    const std::size_t size = format_->sizeOf(sample);
    const os::detail::PriorityLock lock(busy_);
    if (size == 0 || format_->write(sample, message_.data(), message_.size()) == 0) return refuse(sample);
    return postInsteadOfOldest(message_.data(), size, kFirstPriority);
}

bool SendChannel::disconnect(shared_ptr const& channel, bool forward) {
    unlink();
    return base::ChannelElementBase::disconnect(channel, forward);
}

// At most once, because another stream may have a queue of that name later.
void SendChannel::unlink() {
    if (linked_.exchange(false)) queue_->unlink();
}

WriteStatus SendChannel::send(const void* sample, unsigned priority) {
    if (format_->isMemory()) {
        const std::size_t size = format_->sizeOf(sample);
        const WriteStatus status = post(sample, size, priority);
        if (status == WriteSuccess || keepsOldest_) return status;
        const os::detail::PriorityLock lock(busy_);
        return postInsteadOfOldest(sample, size, priority);
    }
    const os::detail::PriorityLock lock(busy_);
    const std::size_t size = format_->write(sample, message_.data(), message_.size());
    if (size == 0) return refuse(sample);
    return keepsOldest_ ? post(message_.data(), size, priority) : postInsteadOfOldest(message_.data(), size, priority);
}

WriteStatus SendChannel::post(const void* message, std::size_t size, unsigned priority) {
    const int error = queue_->send(message, size, priority);
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
WriteStatus SendChannel::postInsteadOfOldest(const void* message, std::size_t size, unsigned priority) {
    WriteStatus status = post(message, size, priority);
    for (long attempt = queue_->size().messages; status == WriteFailure && attempt != 0; --attempt) {
        unsigned taken = 0;
        if (reported_.load(std::memory_order_relaxed) != 0) break;
        (void)queue_->receive(oldest_.data(), taken);
        status = post(message, size, priority);
    }
    return status;
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
