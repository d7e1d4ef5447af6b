// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_rosclock/detail/clock_topic.hpp>

#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/param.h>
#include <ros/subscribe_options.h>
#include <rosgraph_msgs/Clock.h>

#include <exception>
#include <utility>

namespace rtt_rosclock {

namespace {

/// Tells that there is a callback to call. roscpp's own queue can only be waited for.
class NotifyingQueue : public ros::CallbackQueue {
public:
    explicit NotifyingQueue(std::function<void()> onMessage) : onMessage_(std::move(onMessage)) {}
    void addCallback(const ros::CallbackInterfacePtr& callback, uint64_t owner) override {
        ros::CallbackQueue::addCallback(callback, owner);
        onMessage_();
    }

private:
    const std::function<void()> onMessage_;
};

}  // namespace

struct ClockTopic::Subscription {
    explicit Subscription(std::function<void()> onMessage) : queue(std::move(onMessage)) {
        auto options = ros::SubscribeOptions::create<rosgraph_msgs::Clock>(
            "/clock", 1, [this](const rosgraph_msgs::ClockConstPtr& message) { take(*message); }, ros::VoidPtr(),
            &queue);
        subscriber = node.subscribe(options);
    }
    void take(const rosgraph_msgs::Clock& message) {
        time = static_cast<long long>(message.clock.toNSec());
        isNew = true;
    }

    NotifyingQueue queue;
    ros::NodeHandle node;
    ros::Subscriber subscriber;
    long long time = 0;
    bool isNew = false;
};

std::string ClockTopic::whyNot() {
    // A NodeHandle would start the node, and end it with itself.
    if (!ros::isInitialized() || !ros::isStarted() || !ros::ok())
        return "this process is no ROS node; import rtt_rosnode first, or use the manual clock";
    bool isSimulated = false;
    if (ros::param::get("/use_sim_time", isSimulated)) {
        if (isSimulated) return "";
        return "the parameter /use_sim_time is false; set it to true before the node starts";
    }
    if (!ros::master::check()) return "the ROS master at " + ros::master::getURI() + " does not answer";
    return "the parameter /use_sim_time is not set, or is no bool; set it to true before the node starts";
}

ClockTopic::ClockTopic(std::function<void()> onMessage) : subscription_(new Subscription(std::move(onMessage))) {}

ClockTopic::~ClockTopic() {
    // At the end of the process what roscpp needs for it may be gone.
    if (!ros::ok()) static_cast<void>(subscription_.release());
}

bool ClockTopic::poll(long long& time) {
    subscription_->queue.callAvailable(ros::WallDuration(0));
    if (!subscription_->isNew) return false;
    subscription_->isNew = false;
    time = subscription_->time;
    return true;
}

}  // namespace rtt_rosclock
