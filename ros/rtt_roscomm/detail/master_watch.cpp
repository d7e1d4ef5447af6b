// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/master_watch.hpp>

#include <ros/connection_manager.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>
#include <rtt/Logger.hpp>
#include <rtt_ros/xml_rpc.hpp>

#include <chrono>
#include <utility>
#include <vector>

namespace rtt_roscomm::detail {

namespace {

using rtt_ros::callMaster;
using XmlRpc::XmlRpcValue;

constexpr std::chrono::milliseconds kPatience(1000);

XmlRpcValue requestOf(const std::string& name) {
    XmlRpcValue request;
    request[0] = ros::this_node::getName();
    request[1] = name;
    return request;
}

void registerPublisher(const std::string& topic, const std::string& node) {
    const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
    if (!publication) return;
    XmlRpcValue request = requestOf(topic), result;
    request[2] = publication->getDataType();
    request[3] = node;
    (void)callMaster("registerPublisher", request, result, kPatience);
}

/** The node learns of the publishers as if the master had told it. */
void registerSubscriber(const std::string& topic, const std::string& node) {
    XmlRpcValue request = requestOf(topic), publishers;
    request[2] = "*";
    request[3] = node;
    if (!callMaster("registerSubscriber", request, publishers, kPatience)) return;
    std::string host;
    std::uint32_t port = 0;
    if (!ros::network::splitURI(node, host, port)) return;
    XmlRpcValue update, ignored;
    update[0] = "/master";
    update[1] = topic;
    update[2] = publishers;
    (void)rtt_ros::callXmlRpc(host, port, "publisherUpdate", update, ignored, kPatience);
}

void registerService(const std::string& name, const std::string& node) {
    XmlRpcValue request = requestOf(name), result;
    request[2] = "rosrpc://" + ros::network::getHost() + ':' +
                 std::to_string(ros::ConnectionManager::instance()->getTCPPort());
    request[3] = node;
    (void)callMaster("registerService", request, result, kPatience);
}

}  // namespace

MasterWatch& MasterWatch::instance() {
    (void)ros::TopicManager::instance();  // which is then destroyed later than this
    static MasterWatch one;
    return one;
}

MasterWatch::~MasterWatch() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        isRunning_ = false;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void MasterWatch::addUser() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (users_++ != 0 || isRunning_) return;
    if (thread_.joinable()) thread_.join();  // it has ended
    isRunning_ = true;
    thread_ = std::thread([this] { run(); });
}

void MasterWatch::removeUser() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--users_ == 0) changed_.notify_all();
}

void MasterWatch::addService(const std::string& name) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!services_.insert(name).second) return;
    }
    addUser();
}

void MasterWatch::removeService(const std::string& name) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (services_.erase(name) == 0) return;
    }
    removeUser();
}

void MasterWatch::run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (isRunning_ && users_ != 0) {
        lock.unlock();
        if (!ros::isShuttingDown()) look();
        lock.lock();
        changed_.wait_for(lock, std::chrono::seconds(1), [this] { return !isRunning_ || users_ == 0; });
    }
    isRunning_ = false;
}

void MasterWatch::look() {
    XmlRpcValue request, result;
    request[0] = ros::this_node::getName();
    if (!callMaster("getPid", request, result, kPatience)) {
        if (!std::exchange(isAway_, true))
            RTT::log(RTT::Warning) << "the ROS master at " << ros::master::getURI()
                                   << " does not answer. Nodes that are connected stay so, and others find each other "
                                      "when it is back"
                                   << RTT::endlog();
        return;
    }
    if (std::exchange(isAway_, false))
        RTT::log(RTT::Info) << "the ROS master at " << ros::master::getURI() << " answers again" << RTT::endlog();
    const int now = result.getType() == XmlRpcValue::TypeInt ? static_cast<int>(result) : 0;
    const int before = std::exchange(master_, now);
    if (before != 0 && before != now) registerAll();
}

void MasterWatch::registerAll() {
    const std::string node = ros::XMLRPCManager::instance()->getServerURI();
    std::vector<std::string> published, subscribed;
    ros::this_node::getAdvertisedTopics(published);
    ros::this_node::getSubscribedTopics(subscribed);
    std::set<std::string> services;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        services = services_;
    }
    for (const std::string& topic : published) registerPublisher(topic, node);
    for (const std::string& topic : subscribed) registerSubscriber(topic, node);
    for (const std::string& name : services) registerService(name, node);
    RTT::log(RTT::Info) << "this node is registered with the ROS master that was started anew: " << published.size()
                        << " topics published, " << subscribed.size() << " received, " << services.size()
                        << " services" << RTT::endlog();
}

}  // namespace rtt_roscomm::detail
