// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_LANE_HPP
#define RTT_ROSCOMM_DETAIL_LANE_HPP

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt_roscomm/rtt_rostopic_ros_publish_activity.hpp>

#include <atomic>

namespace rtt_roscomm::detail {

/** A thread for one publisher that would delay the others. */
class Lane final : public RTT::Activity {
public:
    explicit Lane(RosPublisher& publisher)
        : RTT::Activity(ORO_SCHED_OTHER, RTT::os::LowestPriority, 0.0, nullptr, "RosPublisher"),
          publisher_(publisher) {
        // A publisher may take its time, and must not be destroyed before it is done.
        setStopTimeout(3600.0);
        if (!start())
            RTT::log(RTT::Error) << "a publisher of ROS has no thread; it sends nothing" << RTT::endlog();
    }
    ~Lane() override {
        (void)stop();
        terminate();
    }

    /** Calls the publisher no more, except where it is calling it now. */
    void leave() { hasLeft_ = true; }

protected:
    void loop() override {
        if (!hasLeft_) publisher_.publish();
    }
    bool breakLoop() override { return true; }

private:
    RosPublisher& publisher_;
    std::atomic<bool> hasLeft_{false};
};

}  // namespace rtt_roscomm::detail

#endif
