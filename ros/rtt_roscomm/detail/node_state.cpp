// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/node_state.hpp>

#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <rtt_roscomm/detail/master_call.hpp>
#include <rtt_roscomm/detail/master_watch.hpp>

#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace rtt_roscomm::detail {

namespace {

/** One thread, which ends when it has nothing to do. It is never joined: nobody can wait for a master that is stopped. */
class Helper {
public:
    static Helper& instance() {
        static Helper* const one = new Helper();
        return *one;
    }
    void execute(std::function<void()> work, std::chrono::milliseconds limit) {
        const auto job = std::make_shared<Job>();
        job->work = std::move(work);
        std::unique_lock<std::mutex> lock(mutex_);
        jobs_.push_back(job);
        if (!isRunning_) {
            isRunning_ = true;
            std::thread([this] { run(); }).detach();
        }
        // What is stuck for one is stuck for all that wait behind it.
        if (isStuck_) return;
        if (!done_.wait_for(lock, limit, [&] { return job->isDone; })) isStuck_ = true;
    }

private:
    struct Job {
        std::function<void()> work;
        bool isDone = false;
    };
    void run() {
        std::unique_lock<std::mutex> lock(mutex_);
        while (!jobs_.empty()) {
            const std::shared_ptr<Job> job = jobs_.front();
            jobs_.pop_front();
            lock.unlock();
            job->work();
            job->work = nullptr;
            lock.lock();
            job->isDone = true;
            isStuck_ = false;
            done_.notify_all();
        }
        isRunning_ = false;
    }
    std::mutex mutex_;
    std::condition_variable done_;
    std::deque<std::shared_ptr<Job>> jobs_;
    bool isRunning_ = false, isStuck_ = false;
};

}  // namespace

bool isNodeReady(std::string& why) {
    if (!ros::isInitialized() || !ros::isStarted()) {
        why = "this process is no ROS node; import rtt_rosnode first";
        return false;
    }
    if (ros::isShuttingDown() || !ros::ok()) {
        why = "the ROS node of this process is shutting down";
        return false;
    }
    XmlRpc::XmlRpcValue request, result;
    request[0] = ros::this_node::getName();
    if (callMaster("getPid", request, result, std::chrono::seconds(1))) return true;
    why = "the ROS master at " + ros::master::getURI() + " does not answer; start roscore";
    return false;
}

void doWithin(std::function<void()> work, std::chrono::milliseconds limit) {
    Helper::instance().execute(std::move(work), limit);
}

bool isDone(const std::function<void()>& work, std::string& why) {
    try {
        work();
        return true;
    } catch (const std::exception& error) {
        why = error.what();
    } catch (const XmlRpc::XmlRpcException& error) {
        why = error.getMessage();
    }
    return false;
}

void keepService(const std::string& name) { MasterWatch::instance().addService(name); }

void dropService(const std::string& name) { MasterWatch::instance().removeService(name); }

}  // namespace rtt_roscomm::detail
