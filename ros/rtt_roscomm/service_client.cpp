// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/service_client.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt_ros/xml_rpc.hpp>
#include <rtt_roscomm/detail/normal_thread.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <ros/connection.h>
#include <ros/connection_manager.h>
#include <ros/network.h>
#include <ros/poll_manager.h>
#include <ros/service_server_link.h>
#include <ros/this_node.h>
#include <ros/transport/transport_tcp.h>

#include <boost/make_shared.hpp>

#include <algorithm>
#include <system_error>
#include <thread>
#include <utility>

namespace rtt_roscomm {

// roscpp lets a call wait for ever that begins while its connection is lost, as by a server that has just been killed.
// Its function that ends calls is private; only an explicit instantiation may name it.
template <void (ros::ServiceServerLink::*Function)()>
struct Opened {
    friend void endCalls(ros::ServiceServerLink& link) { (link.*Function)(); }
};
void endCalls(ros::ServiceServerLink& link);
template struct Opened<&ros::ServiceServerLink::clearCalls>;

namespace {

constexpr std::chrono::milliseconds kMasterAnswers(1000);
constexpr std::chrono::milliseconds kBetweenLooks(50);
/** stop() gives up after a second, unless setStopTimeout() says otherwise. */
constexpr std::chrono::milliseconds kPatienceOfStop(400);

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

ServiceConnection::ServiceConnection(std::string resolved, ServiceType type, double timeout, std::string who,
                                     const RTT::base::TaskCore* owner)
    : name_(std::move(resolved)),
      type_(std::move(type)),
      timeout_(timeout > 0 ? timeout : 0),
      who_(std::move(who)),
      owner_(owner) {}

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
    const Link made = open();
    if (!made) {
        why = "no node offers it, or the master or that node does not answer";
        return nullptr;
    }
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!is_closed_) return link_ = made;
    }
    drop(made);
    why = "it was disconnected";
    return nullptr;
}

// As roscpp does, which asks the master without a limit, and holds a lock that even the end of the node needs.
ServiceConnection::Link ServiceConnection::open() const {
    XmlRpc::XmlRpcValue request, found;
    request[0] = ros::this_node::getName();
    request[1] = name_;
    std::string host;
    std::uint32_t port = 0;
    if (!rtt_ros::callMaster("lookupService", request, found, kMasterAnswers) ||
        found.getType() != XmlRpc::XmlRpcValue::TypeString ||
        !ros::network::splitURI(static_cast<std::string&>(found), host, port))
        return nullptr;
    const auto transport = boost::make_shared<ros::TransportTCP>(&ros::PollManager::instance()->getPollSet());
    if (!transport->connect(host, static_cast<int>(port))) return nullptr;
    const auto connection = boost::make_shared<ros::Connection>();
    ros::ConnectionManager::instance()->addConnection(connection);
    connection->initialize(transport, false, ros::HeaderReceivedFunc());
    // A connection that was refused before it had this object does not become a dropped one. The server sends nothing
    // before it has the header.
    std::uint8_t nothing = 0;
    if (transport->read(&nothing, 1) < 0) {
        connection->drop(ros::Connection::TransportDisconnect);
        return nullptr;
    }
    const auto link = boost::make_shared<ros::ServiceServerLink>(name_, true, type_.md5, type_.md5, ros::M_string());
    link->initialize(connection);
    return connection->isDropped() ? nullptr : link;
}

bool ServiceConnection::callNow(const SentRequest& sent, ros::SerializedMessage& response) {
    std::string why;
    bool isAnswered = false, isGivenUp = false;
    const auto execute = [&] {
        const Link link = connected(why);
        if (!link) return;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            isGivenUp = current_ != &sent;
        }
        if (isGivenUp) return;
        isAnswered = link->call(sent.request, response);
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
    // Another thread waits for roscpp, which has no limit, and nothing that ends its waiting for one call alone.
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
        const bool isAnswered = callNow(*sent, response);
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
    const std::chrono::duration<double> limit(timeout_ == 0 ? 1e9 : timeout_);
    const Clock::time_point begin = Clock::now();
    Clock::time_point running = begin;  // when the component was not being stopped
    bool isEnding = false, isOver = false;
    while (!isEnding && !isOver) {
        const std::chrono::duration<double> left = limit - (Clock::now() - begin), look = kBetweenLooks;
        if (sent.changed.wait_for(lock, std::min(look, left), isDone)) return true;
        const Clock::time_point now = Clock::now();
        if (!isOwnerStopping()) running = now;
        isEnding = now - running >= kPatienceOfStop;
        isOver = now - begin >= limit;
        endLostCall();
    }
    sent.isDone = true;
    lock.unlock();
    failed(isEnding ? "no response, and the component is being stopped"
                    : "no response within " + std::to_string(timeout_) + " s");
    giveUp(sent, isEnding);
    return true;
}

void ServiceConnection::endLostCall() {
    Link lost;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (current_ && link_ && link_->getConnection()->isDropped()) lost = link_;
    }
    if (lost) endCalls(*lost);
}

/** Does stop() wait for the end of a step? */
bool ServiceConnection::isOwnerStopping() const {
    using RTT::base::TaskCore;
    const std::lock_guard<std::mutex> lock(mutex_);  // close() is called before the owner is gone
    return owner_ && !is_closed_ && owner_->getTaskState() >= TaskCore::Running &&
           owner_->getTargetState() < TaskCore::Running;
}

void ServiceConnection::giveUp(const SentRequest& sent, bool isEnding) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto isIt = [&](const std::shared_ptr<SentRequest>& one) { return one.get() == &sent; };
    sent_.erase(std::remove_if(sent_.begin(), sent_.end(), isIt), sent_.end());
    if (!current_) return;
    // A call whose handle nobody collects must not stop all others for ever.
    const bool isOver = isEnding || (timeout_ != 0 && Clock::now() - begun_ >= std::chrono::duration<double>(timeout_));
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
