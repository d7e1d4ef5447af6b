// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/dispatcher.hpp>

#include <rtt/Logger.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/descriptor.hpp>

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
constexpr int kRetry = 5;               // ms, while a buffer is full
constexpr useconds_t kPause = 10000;    // us, after an error of poll()

/** Reports when a queue is made; -1 if nobody has mounted the file system of the queues. */
int watchQueues() {
    os::detail::Descriptor watch(inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    if (watch && inotify_add_watch(watch.get(), "/dev/mqueue", IN_CREATE) != -1) return watch.release();
    log(Info) << "receivers do not notice when a sender makes its queue anew: " << std::strerror(errno)
              << " (/dev/mqueue, inotify)" << endlog();
    return -1;
}

/** The names of the queues that were made since the last call. False if there were more than the system keeps. */
bool takeNames(int watch, std::set<std::string>& names) {
    alignas(inotify_event) char buffer[4096];
    bool isComplete = true;
    ssize_t size = 0;
    while ((size = read(watch, buffer, sizeof buffer)) > 0) {
        for (const char* at = buffer; at < buffer + size;) {
            const auto* const event = reinterpret_cast<const inotify_event*>(at);
            if (event->len != 0) names.insert(std::string("/") + event->name);
            isComplete = isComplete && (event->mask & IN_Q_OVERFLOW) == 0;
            at += sizeof *event + event->len;
        }
    }
    return isComplete;
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
    if (changes_ == -1 || !start())
        log(Critical) << "no messages of queues can be received: " << std::strerror(errno) << endlog();
}

void Dispatcher::wake() const {
    const std::uint64_t one = 1;
    (void)!write(changes_, &one, sizeof one);
}

void Dispatcher::add(ReceiveChannel& channel) {
    const os::MutexLock lock(mutex_);
    for (const ReceiveChannel::Pointer& other : channels_)
        if (other->queueName() == channel.queueName())
            log(Warning) << "queue '" << channel.queueName()
                         << "' has several receivers in this process: each message gets to one of them" << endlog();
    channels_.emplace_back(&channel);
    wake();
}

void Dispatcher::remove(const ReceiveChannel& channel) {
    ReceiveChannel::Pointer last;  // released without the lock
    const os::MutexLock lock(mutex_);
    const auto found = std::find_if(channels_.begin(), channels_.end(),
                                    [&](const ReceiveChannel::Pointer& one) { return one.get() == &channel; });
    if (found == channels_.end()) return;
    last.swap(*found);
    channels_.erase(found);
    wake();
}

void Dispatcher::watch(std::size_t index) {
    const ReceiveChannel& channel = *served_[index];
    polled_[kFirstQueue + index] = {channel.isHeldUp() ? -1 : channel.queue().descriptor(), POLLIN, 0};
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
    polled_.assign(kFirstQueue + served_.size(), {-1, POLLIN, 0});
    polled_[0].fd = changes_;
    polled_[1].fd = newQueues_;
    for (std::size_t i = 0; i != served_.size(); ++i) {
        // Its sender may have made the queue anew before this thread knew it.
        if (std::find(before.begin(), before.end(), served_[i]) == before.end()) (void)served_[i]->followQueue();
        watch(i);
    }
}

// poll() wakes a thread faster than epoll does; a process has few queues.
void Dispatcher::loop() {
    lookAgain();
    for (;;) {
        if (poll(polled_.data(), polled_.size(), patience()) != -1 || errno == EINTR) {
            complained_ = false;
            serve();
            continue;
        }
        if (!std::exchange(complained_, true))
            log(Error) << "messages of queues cannot be received now: " << std::strerror(errno) << endlog();
        usleep(kPause);
        lookAgain();
    }
}

int Dispatcher::patience() const {
    const bool isHeldUp =
        std::any_of(served_.begin(), served_.end(), [](const ReceiveChannel::Pointer& one) { return one->isHeldUp(); });
    return isHeldUp ? kRetry : -1;
}

void Dispatcher::serve() {
    if (polled_[0].revents != 0) lookAgain();
    if (polled_[1].revents != 0) renewQueues();
    for (std::size_t i = 0; i != served_.size(); ++i) {
        ReceiveChannel& channel = *served_[i];
        if (polled_[kFirstQueue + i].revents == 0 && !channel.isHeldUp()) continue;
        const bool wasHeldUp = channel.isHeldUp();
        channel.receive();
        if (wasHeldUp != channel.isHeldUp()) watch(i);
        polled_[kFirstQueue + i].revents = 0;
    }
}

// A sender removes its queue when it ends. When it comes back, it makes a new one.
void Dispatcher::renewQueues() {
    std::set<std::string> names;
    const bool isComplete = takeNames(newQueues_, names);
    for (std::size_t i = 0; i != served_.size(); ++i)
        if ((!isComplete || names.count(served_[i]->queueName()) != 0) && served_[i]->followQueue()) watch(i);
}

}  // namespace RTT::mqueue::detail
