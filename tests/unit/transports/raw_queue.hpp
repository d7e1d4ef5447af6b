// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A message queue without the runtime, for tests that are the other end.
#ifndef OROFORGE_TESTS_RAW_QUEUE_HPP
#define OROFORGE_TESTS_RAW_QUEUE_HPP

#include <string>

#include <fcntl.h>
#include <mqueue.h>

namespace transport_test {

class RawQueue {
public:
    struct Size {
        long messages, bytes;
    };
    /// Opens one.
    explicit RawQueue(const std::string& name) : queue_(mq_open(name.c_str(), O_RDWR | O_NONBLOCK)) {}
    /// Makes one, and removes it in the end.
    RawQueue(const std::string& name, Size size) : made_(name) {
        mq_attr attributes{};
        attributes.mq_maxmsg = size.messages;
        attributes.mq_msgsize = size.bytes;
        queue_ = mq_open(name.c_str(), O_RDWR | O_NONBLOCK | O_CREAT | O_EXCL, 0600, &attributes);
    }
    ~RawQueue() {
        mq_close(queue_);
        if (!made_.empty()) mq_unlink(made_.c_str());
    }
    RawQueue(const RawQueue&) = delete;
    RawQueue& operator=(const RawQueue&) = delete;

    static bool exists(const std::string& name) {
        const mqd_t queue = mq_open(name.c_str(), O_RDONLY);
        return queue != -1 && mq_close(queue) == 0;
    }
    Size size() const {
        mq_attr attributes{};
        mq_getattr(queue_, &attributes);
        return {attributes.mq_maxmsg, attributes.mq_msgsize};
    }
    bool send(const std::string& message) { return mq_send(queue_, message.data(), message.size(), 0) == 0; }
    /// Empty if there is none.
    std::string receive() {
        std::string message(static_cast<std::size_t>(size().bytes), ' ');
        const ssize_t size = mq_receive(queue_, &message[0], message.size(), nullptr);
        message.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
        return message;
    }

private:
    mqd_t queue_ = -1;
    const std::string made_;
};

}  // namespace transport_test

#endif
