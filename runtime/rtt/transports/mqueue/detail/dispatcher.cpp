// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/dispatcher.hpp>

#include <rtt/Logger.hpp>
#include <rtt/os/MutexLock.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <set>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>
#include <utility>

namespace RTT::mqueue::detail {

namespace {

constexpr std::size_t kFirstQueue = 2;  // in polled_

/** Reports when a queue is made; -1 if nobody has mounted the file system of the queues. */
int watchQueues() {
    const int watch = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (watch != -1 && inotify_add_watch(watch, "/dev/mqueue", IN_CREATE) != -1) return watch;
    if (watch != -1) close(watch);
    return -1;
}

/** The names of the queues that were made since the last call. */
std::set<std::string> newNames(int watch) {
    std::set<std::string> names;
    alignas(inotify_event) char buffer[4096];
    ssize_t size = 0;
    while ((size = read(watch, buffer, sizeof buffer)) > 0) {
        for (const char* at = buffer; at < buffer + size;) {
            const auto* const event = reinterpret_cast<const inotify_event*>(at);
            if (event->len != 0) names.insert(std::string("/") + event->name);
            at += sizeof *event + event->len;
        }
    }
    return names;
}

}  // namespace

Dispatcher& Dispatcher::instance() {
    static auto* const dispatcher = new Dispatcher();
    return *dispatcher;
}

Dispatcher::Dispatcher()
    : Activity(ORO_SCHED_RT, os::HighestPriority, 0.0, nullptr, "MQueueDispatch"),
      changes_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      newQueues_(watchQueues()) {
    (void)start();
}

void Dispatcher::wake() const {
    const std::uint64_t one = 1;
    (void)!write(changes_, &one, sizeof one);
}

void Dispatcher::add(ReceiveChannel& channel) {
    const os::MutexLock lock(mutex_);
    channels_.emplace_back(&channel);
    wake();
}

void Dispatcher::remove(const ReceiveChannel& channel) {
    ReceiveChannel::Pointer last;  // released without the lock
    const os::MutexLock lock(mutex_);
    const auto found =
        std::find(channels_.begin(), channels_.end(), ReceiveChannel::Pointer(const_cast<ReceiveChannel*>(&channel)));
    if (found == channels_.end()) return;
    last.swap(*found);
    channels_.erase(found);
    wake();
}

void Dispatcher::lookAgain() {
    std::uint64_t count = 0;
    (void)!read(changes_, &count, sizeof count);
    Channels before;  // released without the lock
    {
        const os::MutexLock lock(mutex_);
        before.swap(served_);
        served_ = channels_;
    }
    polled_ = {{changes_, POLLIN, 0}, {newQueues_, POLLIN, 0}};
    for (const ReceiveChannel::Pointer& channel : served_)
        polled_.push_back({channel->queue().descriptor(), POLLIN, 0});
}

// poll() wakes a thread faster than epoll does; a process has few queues.
void Dispatcher::loop() {
    lookAgain();
    for (;;) {
        const int ready = poll(polled_.data(), polled_.size(), -1);
        if (ready == -1 && errno != EINTR) {
            log(Critical) << "no messages of queues can be received any more: " << std::strerror(errno) << endlog();
            return;
        }
        for (std::size_t i = kFirstQueue; ready > 0 && i != polled_.size(); ++i)
            if (polled_[i].revents != 0) served_[i - kFirstQueue]->receive();
        if (ready > 0 && polled_[1].revents != 0) renewQueues();
        if (ready > 0 && polled_[0].revents != 0) lookAgain();
    }
}

// A sender removes its queue when it ends. When it comes back, it makes a new one.
void Dispatcher::renewQueues() {
    const std::set<std::string> names = newNames(newQueues_);
    for (std::size_t i = 0; i != served_.size(); ++i) {
        ReceiveChannel& channel = *served_[i];
        std::unique_ptr<Queue> made =
            names.count(channel.queueName()) != 0 ? Queue::openForReceiving(channel.queueName()) : nullptr;
        if (!made || made->isSame(channel.queue())) continue;
        polled_[kFirstQueue + i].fd = made->descriptor();
        channel.exchangeQueue(std::move(made));
        log(Info) << "queue '" << channel.queueName() << "' was made anew; its messages are received from now on"
                  << endlog();
    }
}

}  // namespace RTT::mqueue::detail
