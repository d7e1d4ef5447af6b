// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_LANE_HPP
#define RTT_ROSCOMM_DETAIL_LANE_HPP

#include <rtt/Activity.hpp>
#include <rtt_roscomm/rtt_rostopic_ros_publish_activity.hpp>

namespace rtt_roscomm::detail {

/** A thread for one publisher that would delay the others. */
class Lane final : public RTT::Activity {
public:
    explicit Lane(RosPublisher& publisher)
        : RTT::Activity(ORO_SCHED_OTHER, RTT::os::LowestPriority, 0.0, nullptr, "RosPublisher"),
          publisher_(publisher) {
        // A publisher may take its time, and must not be destroyed before it is done.
        setStopTimeout(3600.0);
        (void)start();
    }
    ~Lane() override {
        (void)stop();
        terminate();
    }

protected:
    void loop() override { publisher_.publish(); }
    bool breakLoop() override { return true; }

private:
    RosPublisher& publisher_;
};

}  // namespace rtt_roscomm::detail

#endif
