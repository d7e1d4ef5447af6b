// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/queue.hpp>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/stat.h>
#include <utility>

namespace RTT::mqueue::detail {

namespace {

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
                   " needs more memory than the queues of this user may have together (ulimit -q): give a smaller "
                   "policy.size or policy.data_size, or remove queues that nobody uses from /dev/mqueue";
        case EACCES: return "it belongs to another user, or its name has a second '/'";
        case ENAMETOOLONG: return "its name is too long";
        default: return std::strerror(error);
    }
}

Queue::Size sizeOf(mqd_t queue) {
    mq_attr attributes{};
    (void)mq_getattr(queue, &attributes);
    return {attributes.mq_maxmsg, attributes.mq_msgsize};
}

}  // namespace

Queue::Queue(std::string name, mqd_t descriptor, bool isNew)
    : name_(std::move(name)), descriptor_(descriptor), size_(sizeOf(descriptor)), isNew_(isNew) {}

Queue::~Queue() { (void)mq_close(descriptor_); }

std::unique_ptr<Queue> Queue::open(const std::string& name, Role role, Size size, std::string& why) {
    mq_attr attributes{};
    attributes.mq_maxmsg = size.messages;
    attributes.mq_msgsize = size.bytes;
    // A sender also takes the oldest message out of a full queue, see SendChannel.
    const int how = (role == Role::Sender ? O_RDWR : O_RDONLY) | O_CREAT | O_NONBLOCK | O_CLOEXEC;
    const mqd_t made = mq_open(name.c_str(), how | O_EXCL, S_IRUSR | S_IWUSR, &attributes);
    const bool exists = made == -1 && errno == EEXIST;
    const mqd_t opened = exists ? mq_open(name.c_str(), how, S_IRUSR | S_IWUSR, &attributes) : made;
    if (opened != -1) return std::unique_ptr<Queue>(new Queue(name, opened, !exists));
    why = explain(errno, size);
    return nullptr;
}

std::unique_ptr<Queue> Queue::openForReceiving(const std::string& name) {
    const mqd_t opened = mq_open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    return opened == -1 ? nullptr : std::unique_ptr<Queue>(new Queue(name, opened, false));
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
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const std::int64_t end = now.tv_sec * 1000LL + now.tv_nsec / 1000000 + milliseconds;
    for (;;) {
        pollfd one{descriptor_, POLLIN, 0};
        const int ready = poll(&one, 1, milliseconds);
        if (ready != -1) return ready == 1;
        if (errno != EINTR) return false;
        clock_gettime(CLOCK_MONOTONIC, &now);
        const std::int64_t left = end - (now.tv_sec * 1000LL + now.tv_nsec / 1000000);
        milliseconds = left > 0 ? static_cast<int>(left) : 0;
    }
}

void Queue::unlink() const { (void)mq_unlink(name_.c_str()); }

}  // namespace RTT::mqueue::detail
