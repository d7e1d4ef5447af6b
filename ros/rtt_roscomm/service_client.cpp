// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/service_client.hpp>

#include <rtt/Logger.hpp>
#include <rtt_roscomm/detail/normal_thread.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <ros/connection.h>
#include <ros/ros.h>
#include <ros/service_manager.h>
#include <ros/service_server_link.h>

#include <algorithm>
#include <system_error>
#include <thread>
#include <utility>

namespace rtt_roscomm {

namespace {

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

bool ServiceConnection::callNow(const ros::SerializedMessage& request, ros::SerializedMessage& response,
                                const SentRequest* sent) {
    std::string why;
    bool isAnswered = false, isGivenUp = false;
    const auto execute = [&] {
        const Link link = connected(why);
        if (!link) return;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            isGivenUp = sent && current_ != sent;
        }
        if (isGivenUp) return;
        isAnswered = link->call(request, response);
        if (!isAnswered)
            why = isAlive(*link)
                      ? "the server refused the call, with the text that roscpp wrote above"
                      : "the connection was lost during the call, or the server has another version of the type";
    };
    if (isDone(execute, why) && isAnswered) {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_failing_ = false;
        return true;
    }
    if (!isGivenUp) failed(why);
    return false;
}

bool ServiceConnection::call(const ros::SerializedMessage& request, ros::SerializedMessage& response) {
    if (timeout_ == 0) return callNow(request, response, nullptr);
    const std::shared_ptr<SentRequest> sent = send(request);
    if (!sent || !finish(*sent, true)) return false;
    response = sent->response;
    return sent->isAnswered;
}

std::shared_ptr<SentRequest> ServiceConnection::send(const ros::SerializedMessage& request) {
    const auto sent = std::make_shared<SentRequest>();
    sent->request = request;
    std::unique_lock<std::mutex> lock(mutex_);
    if (is_closed_) return nullptr;
    sent_.push_back(sent);
    try {
        if (!is_working_) std::thread([kept = shared_from_this()] { kept->work(); }).detach();
        is_working_ = true;
    } catch (const std::system_error& error) {
        sent_.pop_back();
        lock.unlock();
        failed(std::string("there is no thread to be had for the call: ") + error.what());
        return nullptr;
    }
    changed_.notify_all();
    return sent;
}

void ServiceConnection::work() {
    detail::becomeNormalThread("rosservice");
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return is_closed_ || !sent_.empty(); });
        if (is_closed_) break;
        const std::shared_ptr<SentRequest> sent = std::move(sent_.front());
        sent_.pop_front();
        current_ = sent.get();
        begun_ = Clock::now();
        lock.unlock();
        ros::SerializedMessage response;
        const bool isAnswered = callNow(sent->request, response, sent.get());
        {
            const std::lock_guard<std::mutex> own(sent->mutex);
            if (!sent->isDone) {
                sent->response = response;
                sent->isAnswered = isAnswered;
                sent->isDone = true;
                sent->changed.notify_all();
            }
        }
        lock.lock();
        current_ = nullptr;
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
    giveUp(sent);
    return true;
}

void ServiceConnection::giveUp(const SentRequest& sent) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto isIt = [&](const std::shared_ptr<SentRequest>& one) { return one.get() == &sent; };
    sent_.erase(std::remove_if(sent_.begin(), sent_.end(), isIt), sent_.end());
    if (!current_) return;
    // A call whose handle nobody collects must not stop all others for ever.
    const bool isOver = Clock::now() - begun_ >= std::chrono::duration<double>(timeout_);
    if (current_ != &sent && !isOver) return;
    current_ = nullptr;
    drop(link_);  // with the lock, because the next call may use the same connection
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
