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
    struct Size {
        long messages, bytes;
    };

    /** For a sender. Opens the queue, which has its own size if it exists already; otherwise makes one of that size.
        Null, with the reason in `why`, if that fails. */
    static std::unique_ptr<Queue> open(const std::string& name, Size size, std::string& why);
    /** The same for a name that must be new: null, with an empty reason, if there is such a queue already. */
    static std::unique_ptr<Queue> make(const std::string& name, Size size, std::string& why);
    /** For a receiver, which makes no queue. Null, with an empty reason, if there is none. */
    static std::unique_ptr<Queue> find(const std::string& name, std::string& why);
    ~Queue();
    Queue(const Queue&) = delete;
    Queue& operator=(const Queue&) = delete;

    const std::string& name() const { return name_; }
    Size size() const { return size_; }
    int descriptor() const { return descriptor_; }
    /** Both are the same queue, not two of the same name. */
    bool isSame(const Queue& other) const;

    /** 0, or the error number: EAGAIN if it is full. Real-time safe, and so is receive(). */
    int send(const void* message, std::size_t size, unsigned priority) const;
    /** The size of the message, or -1 with the error number in errno. `to` has room for size().bytes. */
    long receive(void* to, unsigned& priority) const;
    /** False if none has come within that time. */
    bool waitForMessage(int milliseconds) const;
    /** Removes the name, unless another queue has it by now, so that others make a new queue. Those that have this one
        open keep it. */
    void unlink() const;

private:
    Queue(std::string name, mqd_t descriptor);
    static std::unique_ptr<Queue> opened(const std::string& name, mqd_t descriptor);

    const std::string name_;
    const mqd_t descriptor_;
    const Size size_;
};

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
