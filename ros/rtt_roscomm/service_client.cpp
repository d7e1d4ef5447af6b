// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/service_client.hpp>

#include <rtt/Logger.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <ros/connection.h>
#include <ros/ros.h>
#include <ros/service_manager.h>
#include <ros/service_server_link.h>

#include <chrono>
#include <thread>
#include <utility>

#include <pthread.h>

namespace rtt_roscomm {

namespace {

/** What creates the thread may be a real-time thread. */
void becomeNormalThread() {
    const sched_param normal{};
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &normal);
    pthread_setname_np(pthread_self(), "rosservice");
}

/** A link learns a moment later that its connection was lost. */
bool isAlive(ros::ServiceServerLink& link) { return link.isValid() && !link.getConnection()->isDropped(); }

void finished(SentRequest& sent, bool isAnswered) {
    const std::lock_guard<std::mutex> lock(sent.mutex);
    if (sent.isDone) return;
    sent.isDone = true;
    sent.isAnswered = isAnswered;
    sent.changed.notify_all();
}

}  // namespace

ServiceConnection::ServiceConnection(std::string resolved, ServiceType type, double timeout, std::string who)
    : name_(std::move(resolved)), type_(std::move(type)), timeout_(timeout > 0 ? timeout : 0), who_(std::move(who)) {}

ServiceConnection::~ServiceConnection() { close(); }

bool ServiceConnection::isOpen() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !is_closed_;
}

void ServiceConnection::failed(const std::string& why) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (is_failing_) return;
        is_failing_ = true;
    }
    RTT::log(RTT::Error) << who_ << ": service '" << name_ << "' of type " << type_.service << ": " << why
                         << "; later failures are not reported until a call succeeds" << RTT::endlog();
}

void ServiceConnection::drop(const Link& link) {
    if (link) link->getConnection()->drop(ros::Connection::Destructing);
}

ServiceConnection::Link ServiceConnection::connected(std::string& why) {
    const std::lock_guard<std::mutex> one(connecting_);
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (is_closed_) why = "it was disconnected";
        if (is_closed_ || (link_ && isAlive(*link_))) return is_closed_ ? nullptr : link_;
    }
    if (!isNodeReady(why)) return nullptr;  // roscpp would wait for a master that is stopped
    const Link made = ros::ServiceManager::instance()->createServiceServerLink(name_, true, type_.md5, type_.md5, {});
    if (!made) {
        why = "no node offers it, or the master or that node does not answer";
        return nullptr;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_closed_) {
        drop(made);
        why = "it was disconnected";
        return nullptr;
    }
    return link_ = made;
}

bool ServiceConnection::callNow(const ros::SerializedMessage& request, ros::SerializedMessage& response) {
    std::string why;
    try {
        const Link link = connected(why);
        if (link && link->call(request, response)) {
            const std::lock_guard<std::mutex> lock(mutex_);
            is_failing_ = false;
            return true;
        }
        if (link)
            why = isAlive(*link)
                      ? "the server refused the call, with the text that roscpp wrote above"
                      : "the connection was lost during the call, or the server has another version of the type";
    } catch (const std::exception& error) {
        why = error.what();
    }
    failed(why);
    return false;
}

bool ServiceConnection::call(const ros::SerializedMessage& request, ros::SerializedMessage& response) {
    if (timeout_ == 0) return callNow(request, response);
    const std::shared_ptr<SentRequest> sent = send(request);
    if (!sent || !finish(*sent, true)) return false;
    response = sent->response;
    return sent->isAnswered;
}

std::shared_ptr<SentRequest> ServiceConnection::send(const ros::SerializedMessage& request) {
    const auto sent = std::make_shared<SentRequest>();
    sent->request = request;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_closed_) return nullptr;
    sent_.push_back(sent);
    if (!is_working_) {
        std::thread([kept = shared_from_this()] { kept->work(); }).detach();
        is_working_ = true;
    }
    changed_.notify_all();
    return sent;
}

void ServiceConnection::work() {
    becomeNormalThread();
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return is_closed_ || !sent_.empty(); });
        if (is_closed_) break;
        const std::shared_ptr<SentRequest> sent = std::move(sent_.front());
        sent_.pop_front();
        lock.unlock();
        bool isWaited;
        {
            const std::lock_guard<std::mutex> own(sent->mutex);
            isWaited = !sent->isDone;
        }
        if (isWaited) {
            ros::SerializedMessage response;
            const bool isAnswered = callNow(sent->request, response);
            const std::lock_guard<std::mutex> own(sent->mutex);
            if (!sent->isDone) {
                sent->response = response;
                sent->isAnswered = isAnswered;
                sent->isDone = true;
                sent->changed.notify_all();
            }
        }
        lock.lock();
    }
    is_working_ = false;
    changed_.notify_all();
}

bool ServiceConnection::finish(SentRequest& sent, bool wait) {
    std::unique_lock<std::mutex> lock(sent.mutex);
    if (sent.isDone || !wait) return sent.isDone;
    const auto isDone = [&] { return sent.isDone; };
    if (timeout_ == 0) {
        sent.changed.wait(lock, isDone);
        return true;
    }
    if (sent.changed.wait_for(lock, std::chrono::duration<double>(timeout_), isDone)) return true;
    sent.isDone = true;
    lock.unlock();
    failed("no response within " + std::to_string(timeout_) + " s");
    Link late;
    {
        const std::lock_guard<std::mutex> own(mutex_);
        late = link_;
    }
    drop(late);
    return true;
}

void ServiceConnection::close() {
    Link last;
    std::deque<std::shared_ptr<SentRequest>> waiting;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (is_closed_) return;
        is_closed_ = true;
        last.swap(link_);
        waiting.swap(sent_);
        changed_.notify_all();
    }
    drop(last);
    for (const auto& sent : waiting) finished(*sent, false);
    // The thread owns this object, too. It ends at once unless the master, or the network, does not answer.
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(2), [this] { return !is_working_; });
}

}  // namespace rtt_roscomm
