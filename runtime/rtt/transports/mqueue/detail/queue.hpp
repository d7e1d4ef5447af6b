// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_DETAIL_QUEUE_HPP
#define ORO_MQUEUE_DETAIL_QUEUE_HPP

#include <cstddef>
#include <memory>
#include <string>

#include <mqueue.h>

namespace RTT {
namespace mqueue {
namespace detail {

/** The priority of a first message: before all others, and never delivered as a sample. Programs of the original
    toolchain send it with that of samples, 0. */
constexpr unsigned kFirstPriority = 1;

/** A POSIX message queue that this process has open. No function blocks, except waitForMessage(). */
class Queue {
public:
    enum class Role { Sender, Receiver };
    struct Size {
        long messages, bytes;
    };

    /** Opens the queue, which has its own size if it exists already; otherwise makes one of that size. Null, with the
        reason in `why`, if that fails. */
    static std::unique_ptr<Queue> open(const std::string& name, Role role, Size size, std::string& why);
    /** Null if there is none. */
    static std::unique_ptr<Queue> openForReceiving(const std::string& name);
    ~Queue();
    Queue(const Queue&) = delete;
    Queue& operator=(const Queue&) = delete;

    const std::string& name() const { return name_; }
    Size size() const { return size_; }
    /** open() has made it. */
    bool isNew() const { return isNew_; }
    int descriptor() const { return descriptor_; }
    /** Both are the same queue, not two of the same name. */
    bool isSame(const Queue& other) const;

    /** 0, or the error number: EAGAIN if it is full. Real-time safe, and so is receive(). */
    int send(const void* message, std::size_t size, unsigned priority) const;
    /** The size of the message, or -1 with the error number in errno. `to` has room for size().bytes. */
    long receive(void* to, unsigned& priority) const;
    /** False if none has come within that time. */
    bool waitForMessage(int milliseconds) const;
    /** Removes the name, so that others make a new queue. Those that have this one open keep it. */
    void unlink() const;

private:
    Queue(std::string name, mqd_t descriptor, bool isNew);

    const std::string name_;
    const mqd_t descriptor_;
    const Size size_;
    const bool isNew_;
};

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
