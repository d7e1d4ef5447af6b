// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The thread that sends what ports have written to topics, for transports of users, too.
#ifndef RTT_ROSCOMM_RTT_ROSTOPIC_ROS_PUBLISH_ACTIVITY_HPP
#define RTT_ROSCOMM_RTT_ROSTOPIC_ROS_PUBLISH_ACTIVITY_HPP

#include <rtt/Activity.hpp>

#include <boost/shared_ptr.hpp>
#include <memory>

namespace rtt_roscomm {

namespace detail {
class DuePublisher;
}

/** One end of a stream, which has samples to send. */
struct RosPublisher {
    virtual ~RosPublisher() = default;
    /** Sends all that waits. Never executed by two threads at once. */
    virtual void publish() = 0;
};

/**
 * One thread of the lowest priority (ORO_SCHED_OTHER) for all topics of the process, so that a thread that writes into a
 * port never waits for the network. It runs from the first publisher to the last.
 *
 * A RosPublisher of a user gets a thread of its own, so that a slow one delays no other.
 */
class RosPublishActivity : public RTT::Activity {
public:
    typedef boost::shared_ptr<RosPublishActivity> shared_ptr;
    static shared_ptr Instance();
    ~RosPublishActivity() override;

    /** From now on, trigger() has publish() called. Not real-time safe. */
    void addPublisher(RosPublisher* publisher);
    /** Waits until publish() of this one has returned, unless publish() itself calls this. Not real-time safe. */
    void removePublisher(RosPublisher* publisher);

    /** For the publishers of this library: sends what this one has, soon. Real-time safe. */
    void publishSoon(detail::DuePublisher& publisher);
    /** They keep the thread running. Not real-time safe. */
    void addUser();
    void removeUser();

protected:
    void loop() override;
    bool breakLoop() override { return true; }

private:
    struct Parts;
    RosPublishActivity();
    const std::unique_ptr<Parts> parts_;
};

}  // namespace rtt_roscomm

#endif
