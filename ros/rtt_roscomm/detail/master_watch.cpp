// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/master_watch.hpp>

#include <ros/connection_manager.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/publication.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>
#include <rtt/Logger.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt_ros/node.hpp>
#include <rtt_ros/xml_rpc.hpp>
#include <rtt_roscomm/detail/normal_thread.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

namespace rtt_roscomm::detail {

namespace {

using rtt_ros::callMaster;
using XmlRpc::XmlRpcValue;

constexpr std::chrono::milliseconds kMasterPatience(1000);

XmlRpcValue requestOf(const std::string& name) {
    XmlRpcValue request;
    request[0] = ros::this_node::getName();
    request[1] = name;
    return request;
}

bool registerPublisher(const std::string& topic, const std::string& node) {
    const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
    if (!publication) return true;
    XmlRpcValue request = requestOf(topic), result;
    request[2] = publication->getDataType();
    request[3] = node;
    if (!callMaster("registerPublisher", request, result, kMasterPatience)) return false;
    // It may have been closed meanwhile.
    if (ros::TopicManager::instance()->lookupPublication(topic)) return true;
    XmlRpcValue taken = requestOf(topic);
    taken[2] = node;
    return callMaster("unregisterPublisher", taken, result, kMasterPatience);
}

/** The node learns of the publishers as if the master had told it. */
bool registerSubscriber(const std::string& topic, const std::string& node) {
    XmlRpcValue request = requestOf(topic), publishers;
    request[2] = "*";
    request[3] = node;
    if (!callMaster("registerSubscriber", request, publishers, kMasterPatience)) return false;
    std::string host;
    std::uint32_t port = 0;
    if (!ros::network::splitURI(node, host, port)) return true;
    XmlRpcValue update, ignored;
    update[0] = "/master";
    update[1] = topic;
    update[2] = publishers;
    return rtt_ros::callXmlRpc(host, port, "publisherUpdate", update, ignored, kMasterPatience).empty();
}

std::string serviceUri() {
    return "rosrpc://" + ros::network::getHost() + ':' +
           std::to_string(ros::ConnectionManager::instance()->getTCPPort());
}

bool registerService(const std::string& name, const std::string& node) {
    XmlRpcValue request = requestOf(name), result;
    request[2] = serviceUri();
    request[3] = node;
    return callMaster("registerService", request, result, kMasterPatience);
}

const RTT::os::CleanupFunction atExit([] { MasterWatch::instance().stop(); }, RTT::os::StopDefault);

}  // namespace

MasterWatch& MasterWatch::instance() {
    static MasterWatch* const one = new MasterWatch();
    return *one;
}

void MasterWatch::addUser() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++users_;
    if (isRunning_ || isStopped_) return;
    std::string why;
    isRunning_ = isDone([this] { std::thread([this] { run(); }).detach(); }, why);
    if (!isRunning_)
        RTT::log(RTT::Warning) << "there is no thread that watches the ROS master: " << why << RTT::endlog();
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

void MasterWatch::keep(std::function<void()> work) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        kept_.push_back(std::move(work));
    }
    addUser();
}

void MasterWatch::stop() {
    std::unique_lock<std::mutex> lock(mutex_);
    isStopped_ = true;
    changed_.notify_all();
    (void)changed_.wait_for(lock, std::chrono::seconds(2), [this] { return !isRunning_; });
}

void MasterWatch::run() {
    becomeNormalThread("ros_master");
    std::unique_lock<std::mutex> lock(mutex_);
    while (!isStopped_ && users_ != 0) {
        lock.unlock();
        if (ros::isShuttingDown())
            tellIfNodeIsLost();
        else
            look();
        lock.lock();
        changed_.wait_for(lock, std::chrono::seconds(1), [this] { return isStopped_ || users_ == 0; });
    }
    isRunning_ = false;
    changed_.notify_all();
}

void MasterWatch::look() {
    const Master master = ask();
    if (master == Master::Away) {
        if (!std::exchange(isAway_, true))
            RTT::log(RTT::Warning) << "the ROS master at " << ros::master::getURI()
                                   << " does not answer. Nodes that are connected stay so, and others find each other "
                                      "when it is back"
                                   << RTT::endlog();
        return;
    }
    if (std::exchange(isAway_, false))
        RTT::log(RTT::Info) << "the ROS master at " << ros::master::getURI() << " answers again" << RTT::endlog();
    workKept();
    isForgotten_ = isForgotten_ || master == Master::New;
    if (isForgotten_) isForgotten_ = !registerAll();
}

void MasterWatch::tellIfNodeIsLost() {
    if (isLost_ || !rtt_ros::isNodeLost()) return;
    isLost_ = true;
    RTT::log(RTT::Error) << "the ROS node " << ros::this_node::getName()
                         << " has been shut down, because another node took its name, or by 'rosnode kill' or "
                            "ros::shutdown(). Its topics and services are gone until the program is started again"
                         << RTT::endlog();
}

MasterWatch::Master MasterWatch::ask() const {
    XmlRpcValue answer;
    const XmlRpcValue request = requestOf(ros::this_node::getName());
    const std::string why = rtt_ros::callXmlRpc(ros::master::getHost(), ros::master::getPort(), "lookupNode", request,
                                                answer, kMasterPatience);
    if (!why.empty() || answer.getType() != XmlRpcValue::TypeArray || answer.size() != 3 ||
        answer[0].getType() != XmlRpcValue::TypeInt)
        return Master::Away;
    return static_cast<int>(answer[0]) == 1 ? Master::KnowsUs : Master::New;
}

bool MasterWatch::isWatching() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !isStopped_ && !ros::isShuttingDown();
}

/** False if that ended early, and has to be done again. */
bool MasterWatch::registerAll() {
    const std::string node = ros::XMLRPCManager::instance()->getServerURI();
    std::vector<std::string> published, subscribed;
    ros::this_node::getAdvertisedTopics(published);
    ros::this_node::getSubscribedTopics(subscribed);
    std::set<std::string> services;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        services = services_;
    }
    for (const std::string& name : services) {
        if (!isWatching() || !registerService(name, node)) return false;
        const std::lock_guard<std::mutex> lock(mutex_);
        if (services_.count(name) != 0) continue;
        // It was taken back meanwhile.
        kept_.push_back([name] {
            XmlRpcValue request = requestOf(name), ignored;
            request[2] = serviceUri();
            (void)callMaster("unregisterService", request, ignored, kMasterPatience);
        });
        ++users_;
    }
    // Those that roscpp itself offers.
    std::size_t count = published.size() + subscribed.size() + services.size();
    for (const char* const own : {"/get_loggers", "/set_logger_level"}) {
        const std::string name = ros::this_node::getName() + own;
        if (!ros::ServiceManager::instance()->lookupServicePublication(name)) continue;
        if (!isWatching() || !registerService(name, node)) return false;
        ++count;
    }
    for (const std::string& topic : subscribed)
        if (!isWatching() || !registerSubscriber(topic, node)) return false;
    for (const std::string& topic : published)
        if (!isWatching() || !registerPublisher(topic, node)) return false;
    if (count != 0)
        RTT::log(RTT::Info) << "the ROS master did not know this node any more; its " << count
                            << " topics and services are registered again" << RTT::endlog();
    return true;
}

void MasterWatch::workKept() {
    std::vector<std::function<void()>> all;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        all.swap(kept_);
    }
    for (const std::function<void()>& work : all) {
        std::string why;
        if (!isDone(work, why)) RTT::log(RTT::Error) << "a call of roscpp failed: " << why << RTT::endlog();
        removeUser();
    }
}

}  // namespace rtt_roscomm::detail
