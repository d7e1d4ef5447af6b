// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_rosclock/detail/clock_topic.hpp>

#include <rtt_ros/node.hpp>
#include <rtt_ros/xml_rpc.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/node_handle.h>
#include <ros/subscribe_options.h>
#include <ros/this_node.h>
#include <rosgraph_msgs/Clock.h>

#include <chrono>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rtt_rosclock {

namespace {

constexpr std::chrono::milliseconds kAnswers{1000};
constexpr std::chrono::milliseconds kUnsubscribes{2000};

}  // namespace

/// Tells that there is a callback to call. roscpp's own queue can only be waited for.
class NotifyingQueue : public ros::CallbackQueue {
public:
    explicit NotifyingQueue(std::function<void()> onMessage) : onMessage_(std::move(onMessage)) {}
    void addCallback(const ros::CallbackInterfacePtr& callback, uint64_t owner) override {
        ros::CallbackQueue::addCallback(callback, owner);
        const std::lock_guard<std::mutex> lock(mutex_);
        if (onMessage_) onMessage_();
    }
    void disarm() {
        const std::lock_guard<std::mutex> lock(mutex_);
        onMessage_ = nullptr;
    }

private:
    std::mutex mutex_;
    std::function<void()> onMessage_;
};

struct ClockTopic::Subscription {
    explicit Subscription(std::function<void()> onMessage) : queue(std::move(onMessage)) {
        auto options = ros::SubscribeOptions::create<rosgraph_msgs::Clock>(
            "/clock", 1, [this](const rosgraph_msgs::ClockConstPtr& message) { take(*message); }, ros::VoidPtr(), &queue);
        std::string why;
        if (!rtt_roscomm::isDone([&] { subscriber = node.subscribe(options); }, why)) throw std::runtime_error(why);
        if (!subscriber) throw std::runtime_error("the node is ending");
    }
    /// True if nothing of ROS refers to it any more. Waits for the master.
    bool end() {
        std::string why;
        const bool hasEnded = rtt_roscomm::isDone([this] { subscriber.shutdown(); }, why);
        // A node that is ending keeps its subscriptions, and does not say until when.
        return hasEnded && !ros::isShuttingDown();
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

// Subscriptions that are closed, and that threads of ROS may still use. Reachable, so that they are no leak to tools.
struct ClockTopic::Closed {
    static Closed& instance() {
        static Closed* const one = new Closed;
        return *one;
    }
    void add(const std::shared_ptr<Subscription>& subscription) {
        const std::lock_guard<std::mutex> lock(mutex);
        all.push_back(subscription);
    }
    /// roscpp holds a lock while it tells the master, and could not even end the node then. So those that are closed while
    /// the master is silent end with a later one.
    void endAll() {
        std::string why;
        if (!rtt_ros::isNodeReady(why)) return;
        std::vector<std::shared_ptr<Subscription>> mine;
        {
            const std::lock_guard<std::mutex> lock(mutex);
            mine.swap(all);
        }
        for (const auto& one : mine)
            if (!one->end()) add(one);
    }
    std::mutex mutex;
    std::vector<std::shared_ptr<Subscription>> all;
};

std::string ClockTopic::whyNot() {
    std::string why;
    if (!rtt_ros::isNodeReady(why)) return why.empty() ? "this process cannot be a ROS node; the log says why" : why;
    XmlRpc::XmlRpcValue request, value;
    request[0] = ros::this_node::getName();
    request[1] = "/use_sim_time";
    if (!rtt_ros::callMaster("getParam", request, value, kAnswers))
        return "the ROS master gives no parameter /use_sim_time; set it to true before the node starts";
    if (value.getType() != XmlRpc::XmlRpcValue::TypeBoolean)
        return "the parameter /use_sim_time is no bool; set it to true before the node starts";
    if (!static_cast<bool>(value))
        return "the parameter /use_sim_time is false; set it to true before the node starts";
    return "";
}

ClockTopic::ClockTopic(std::function<void()> onMessage)
    : subscription_(std::make_shared<Subscription>(std::move(onMessage))) {}

ClockTopic::~ClockTopic() { close(); }

void ClockTopic::close() {
    if (isClosed_.exchange(true)) return;
    subscription_->queue.disarm();
    Closed::instance().add(subscription_);
    rtt_roscomm::doWithin([] { Closed::instance().endAll(); }, kUnsubscribes);
}

bool ClockTopic::poll(long long& time) {
    subscription_->queue.callAvailable(ros::WallDuration(0));
    if (!subscription_->isNew) return false;
    subscription_->isNew = false;
    time = subscription_->time;
    return true;
}

}  // namespace rtt_rosclock
