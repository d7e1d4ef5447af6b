// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/node_state.hpp>

#include <rtt/Logger.hpp>
#include <rtt_ros/guarded.hpp>
#include <rtt_roscomm/detail/master_watch.hpp>
#include <rtt_roscomm/detail/normal_thread.hpp>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace rtt_roscomm {

namespace {

constexpr std::chrono::milliseconds kEndPatience(2000);
constexpr std::chrono::seconds kBetweenLooks(1);

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
        if (!isRunning_ && !start()) return;
        // What is stuck for one is stuck for all that wait behind it.
        if (isStuck_ || limit.count() == 0) return;
        if (!done_.wait_for(lock, limit, [&] { return job->isDone; })) isStuck_ = true;
    }

private:
    struct Job {
        std::function<void()> work;
        bool isDone = false;
    };
    /** If there can be no thread now, the next call tries again. */
    bool start() {
        std::string why;
        isRunning_ = isDone([this] { std::thread([this] { run(); }).detach(); }, why);
        if (!isRunning_) RTT::log(RTT::Error) << "no thread for calls of the ROS master: " << why << RTT::endlog();
        return isRunning_;
    }
    void run() {
        detail::becomeNormalThread("ros_calls");
        std::unique_lock<std::mutex> lock(mutex_);
        while (!jobs_.empty()) {
            const std::shared_ptr<Job> job = jobs_.front();
            jobs_.pop_front();
            lock.unlock();
            std::string why;
            if (!isDone(job->work, why)) RTT::log(RTT::Error) << "a call of roscpp failed: " << why << RTT::endlog();
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

std::function<void()> nowOrWhenThere(std::function<void()> work) {
    return [work = std::move(work)] {
        typedef std::chrono::steady_clock Clock;
        // Looking for a master that is stopped takes 0.8 s: a program with a hundred topics ends in time so.
        static Clock::time_point lookAgain;  // of the helper's thread
        std::string why;
        const bool isSilent = isNode(why) && (Clock::now() < lookAgain || !isNodeReady(why));
        if (!isSilent || !isNode(why)) {
            work();  // a node that has been shut down asks nobody
            return;
        }
        if (Clock::now() >= lookAgain) lookAgain = Clock::now() + kBetweenLooks;
        detail::MasterWatch::instance().keep(work);
    };
}

}  // namespace

void doWithin(std::function<void()> work, std::chrono::milliseconds limit) {
    Helper::instance().execute(std::move(work), limit);
}

void endWithMaster(std::function<void()> work) { doWithin(nowOrWhenThere(std::move(work)), kEndPatience); }

void endWithMasterLater(std::function<void()> work) {
    doWithin(nowOrWhenThere(std::move(work)), std::chrono::milliseconds(0));
}

void keepService(const std::string& name) { detail::MasterWatch::instance().addService(name); }
void dropService(const std::string& name) { detail::MasterWatch::instance().removeService(name); }

bool isDone(const std::function<void()>& work, std::string& why) {
    const std::string problem = rtt_ros::problemIn(work);
    if (!problem.empty()) why = problem;
    return problem.empty();
}

}  // namespace rtt_roscomm
