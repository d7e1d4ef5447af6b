// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_DETAIL_DISPATCHER_HPP
#define ORO_MQUEUE_DETAIL_DISPATCHER_HPP

#include <rtt/Activity.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/transports/mqueue/detail/receive_channel.hpp>

#include <poll.h>
#include <string>
#include <vector>

namespace RTT {
namespace mqueue {
namespace detail {

/** The thread that receives the messages of all input streams of the process, "MQueueDispatch". It sleeps until there
    is one; only while a buffer is full does it look from time to time. Any thread may add and remove channels. */
class Dispatcher final : public Activity {
public:
    /** Made at the first call, and never destroyed. */
    static Dispatcher& instance();

    /** Logs a warning if another channel of this process receives from the same queue. */
    void add(ReceiveChannel& channel);
    void remove(const ReceiveChannel& channel);

protected:
    void loop() override;
    bool breakLoop() override { return false; }

private:
    typedef std::vector<ReceiveChannel::Pointer> Channels;

    Dispatcher();
    void wake() const;
    void serve();
    void lookAgain();
    void renewQueues();
    void watch(std::size_t index);
    int patience() const;

    const int changes_;    // an eventfd: channels_ has changed
    const int newQueues_;  // inotify; -1 if this system does not show the queues as files
    os::Mutex mutex_;      // guards channels_
    Channels channels_;
    // Used only by the thread.
    Channels served_;
    std::vector<pollfd> polled_;  // changes_, newQueues_ and the queues of served_
    bool complained_ = false;
};

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
