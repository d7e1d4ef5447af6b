// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/queue.hpp>

#include <rtt/os/fosi.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/stat.h>
#include <utility>

namespace RTT::mqueue::detail {

namespace {

constexpr int kMode = O_NONBLOCK | O_CLOEXEC;
// A sender also takes the oldest message out of a full queue, see SendChannel.
constexpr int kSender = O_RDWR | O_CREAT | kMode;

std::string limit(const char* name) {
    std::ifstream file(std::string("/proc/sys/fs/mqueue/") + name);
    std::string value;
    return file >> value ? value : "unknown";
}

std::string explain(int error, Queue::Size size) {
    const std::string wanted = std::to_string(size.messages) + " messages of " + std::to_string(size.bytes) + " bytes";
    switch (error) {
        case EINVAL:
            return "this system does not make queues of " + wanted + "; its limits are msg_max " + limit("msg_max") +
                   " and msgsize_max " + limit("msgsize_max") + " in /proc/sys/fs/mqueue";
        case EMFILE:
        case ENOMEM:
            return "a queue of " + wanted +
                   " needs more memory than the queues of this user may have together (ulimit -q), or this process has "
                   "no descriptors left (ulimit -n): give a smaller policy.size or policy.data_size, or remove queues "
                   "that nobody uses from /dev/mqueue";
        case ENOSPC: return "this system has as many queues as it allows (queues_max in /proc/sys/fs/mqueue)";
        case EACCES: return "it belongs to another user";
        case ENAMETOOLONG: return "its name is too long";
        default: return std::strerror(error);
    }
}

mq_attr attributesOf(Queue::Size size) {
    mq_attr attributes{};
    attributes.mq_maxmsg = size.messages;
    attributes.mq_msgsize = size.bytes;
    return attributes;
}

Queue::Size sizeOf(mqd_t queue) {
    mq_attr attributes{};
    (void)mq_getattr(queue, &attributes);
    return {attributes.mq_maxmsg, attributes.mq_msgsize};
}

std::int64_t nowInMs() { return rtos_get_time_ns() / 1000000; }

}  // namespace

Queue::Queue(std::string name, mqd_t descriptor)
    : name_(std::move(name)), descriptor_(descriptor), size_(sizeOf(descriptor)) {}

Queue::~Queue() { (void)mq_close(descriptor_); }

std::unique_ptr<Queue> Queue::opened(const std::string& name, mqd_t descriptor) {
    return descriptor == -1 ? nullptr : std::unique_ptr<Queue>(new Queue(name, descriptor));
}

std::unique_ptr<Queue> Queue::open(const std::string& name, Size size, std::string& why) {
    mq_attr attributes = attributesOf(size);
    auto queue = opened(name, mq_open(name.c_str(), kSender, S_IRUSR | S_IWUSR, &attributes));
    if (!queue) why = explain(errno, size);
    return queue;
}

std::unique_ptr<Queue> Queue::make(const std::string& name, Size size, std::string& why) {
    mq_attr attributes = attributesOf(size);
    auto queue = opened(name, mq_open(name.c_str(), kSender | O_EXCL, S_IRUSR | S_IWUSR, &attributes));
    if (!queue && errno != EEXIST) why = explain(errno, size);
    return queue;
}

std::unique_ptr<Queue> Queue::find(const std::string& name, std::string& why) {
    auto queue = opened(name, mq_open(name.c_str(), O_RDONLY | kMode));
    if (!queue && errno != ENOENT) why = explain(errno, {0, 0});
    return queue;
}

bool Queue::isSame(const Queue& other) const {
    struct stat mine, its;
    return fstat(descriptor_, &mine) == 0 && fstat(other.descriptor_, &its) == 0 && mine.st_dev == its.st_dev &&
           mine.st_ino == its.st_ino;
}

int Queue::send(const void* message, std::size_t size, unsigned priority) const {
    while (mq_send(descriptor_, static_cast<const char*>(message), size, priority) != 0)
        if (errno != EINTR) return errno;
    return 0;
}

long Queue::receive(void* to, unsigned& priority) const {
    for (;;) {
        const auto size = static_cast<std::size_t>(size_.bytes);
        const ssize_t received = mq_receive(descriptor_, static_cast<char*>(to), size, &priority);
        if (received != -1 || errno != EINTR) return received;
    }
}

bool Queue::waitForMessage(int milliseconds) const {
    for (const std::int64_t end = nowInMs() + milliseconds;;) {
        pollfd one{descriptor_, POLLIN, 0};
        const int ready = poll(&one, 1, milliseconds);
        if (ready != -1) return ready == 1;
        if (errno != EINTR) return false;
        const std::int64_t left = end - nowInMs();
        milliseconds = left > 0 ? static_cast<int>(left) : 0;
    }
}

void Queue::unlink() const {
    std::string why;
    const std::unique_ptr<Queue> named = find(name_, why);
    if (named && named->isSame(*this)) (void)mq_unlink(name_.c_str());
}

}  // namespace RTT::mqueue::detail
