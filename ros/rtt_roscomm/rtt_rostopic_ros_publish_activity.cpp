// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/rtt_rostopic_ros_publish_activity.hpp>

#include <rtt/Logger.hpp>
#include <rtt_roscomm/detail/due_publisher.hpp>
#include <rtt_roscomm/detail/lane.hpp>

#include <algorithm>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace rtt_roscomm {

using detail::DuePublisher;
using detail::Lane;

struct RosPublishActivity::Parts {
    typedef std::pair<RosPublisher*, std::unique_ptr<Lane>> Foreign;
    detail::DueList due;
    std::mutex mutex;  // of all below
    std::vector<Foreign> foreign;
    std::vector<std::unique_ptr<Lane>> left;  // whose publishers removed themselves
    unsigned users = 0;

    std::vector<Foreign>::iterator find(const RosPublisher* publisher) {
        return std::find_if(foreign.begin(), foreign.end(),
                            [&](const Foreign& one) { return one.first == publisher; });
    }
    /** Those whose threads the caller can end, without the lock. */
    std::vector<std::unique_ptr<Lane>> takeLeft() {
        std::vector<std::unique_ptr<Lane>> taken;
        for (std::unique_ptr<Lane>& one : left)
            if (!one->isSelf()) taken.push_back(std::move(one));
        left.erase(std::remove(left.begin(), left.end(), nullptr), left.end());
        return taken;
    }
};

// Never destroyed: a thread of a static object of a user may write until the very end of the process.
RosPublishActivity::shared_ptr RosPublishActivity::Instance() {
    static const shared_ptr* const instance = new shared_ptr(new RosPublishActivity());
    return *instance;
}

RosPublishActivity::RosPublishActivity()
    : RTT::Activity(ORO_SCHED_OTHER, RTT::os::LowestPriority, 0.0, nullptr, "RosPublishActivity"),
      parts_(std::make_unique<Parts>()) {}

RosPublishActivity::~RosPublishActivity() {
    (void)stop();
    terminate();
}

void RosPublishActivity::addUser() {
    const std::lock_guard<std::mutex> lock(parts_->mutex);
    ++parts_->users;
    if (!isActive() && !start())
        RTT::log(RTT::Error) << "the thread that sends to topics of ROS does not start; nothing is sent" << RTT::endlog();
}

// The thread takes the mutex, so this must not hold it while it waits for the thread.
void RosPublishActivity::removeUser() {
    {
        const std::lock_guard<std::mutex> lock(parts_->mutex);
        if (--parts_->users != 0) return;
    }
    if (isSelf()) return;  // it has nothing to do, and goes on with the next publisher
    (void)stop();
    const std::lock_guard<std::mutex> lock(parts_->mutex);
    if (parts_->users != 0 && !isActive()) (void)start();
}

void RosPublishActivity::addPublisher(RosPublisher* publisher) {
    auto lane = std::make_unique<Lane>(*publisher);
    std::vector<std::unique_ptr<Lane>> left;
    {
        const std::lock_guard<std::mutex> lock(parts_->mutex);
        left = parts_->takeLeft();
        if (parts_->find(publisher) != parts_->foreign.end()) return;  // it is there already
        parts_->foreign.emplace_back(publisher, std::move(lane));
    }
    addUser();
}

void RosPublishActivity::removePublisher(RosPublisher* publisher) {
    std::unique_ptr<Lane> lane;
    std::vector<std::unique_ptr<Lane>> left;
    {
        const std::lock_guard<std::mutex> lock(parts_->mutex);
        const auto found = parts_->find(publisher);
        if (found == parts_->foreign.end()) return;
        lane = std::move(found->second);
        parts_->foreign.erase(found);
        left = parts_->takeLeft();
        lane->leave();
        if (lane->isSelf()) parts_->left.push_back(std::move(lane));
    }
    removeUser();
}

void RosPublishActivity::publishSoon(DuePublisher& publisher) {
    if (parts_->due.add(publisher)) (void)trigger();
}

void RosPublishActivity::loop() {
    {
        const std::lock_guard<std::mutex> lock(parts_->mutex);
        for (const Parts::Foreign& one : parts_->foreign) (void)one.second->trigger();
    }
    parts_->due.takeAll([](DuePublisher& one) {
        try {
            one.publishDue();
        } catch (const std::exception& error) {
            RTT::log(RTT::Error) << "a topic of ROS cannot be served: " << error.what() << RTT::endlog();
        }
    });
}

}  // namespace rtt_roscomm
