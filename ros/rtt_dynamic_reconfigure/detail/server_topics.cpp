// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/detail/server_topics.hpp>

#include <ros/init.h>
#include <ros/names.h>
#include <ros/node_handle.h>
#include <rtt/Logger.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <exception>
#include <utility>

namespace rtt_dynamic_reconfigure::detail {

namespace {


}  // namespace

std::shared_ptr<ServerTopics> ServerTopics::open(const std::string& ns, Setter setter, std::string& why) {
    if (!rtt_roscomm::isNodeReady(why)) return nullptr;
    const std::shared_ptr<ServerTopics> made(new ServerTopics(std::move(setter)));
    if (made->advertise(ns, why)) return made;
    made->close();
    return nullptr;
}

ServerTopics::~ServerTopics() = default;

bool ServerTopics::advertise(const std::string& ns, std::string& why) {
    const bool isFine = rtt_roscomm::isDone(
        [&] {
            typedef dynamic_reconfigure::ReconfigureRequest Request;
            typedef dynamic_reconfigure::ReconfigureResponse Response;
            (void)ros::names::resolve(ns);  // Throws if it is no name; a handle would do so, too, and lose memory.
            ros::NodeHandle node(ns);
            descriptions_ = node.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true);
            updates_ = node.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, true);
            const std::weak_ptr<ServerTopics> weak = shared_from_this();
            ros::AdvertiseServiceOptions options;
            options.init<Request, Response>("set_parameters", [weak](Request& request, Response& response) {
                const std::shared_ptr<ServerTopics> self = weak.lock();
                return self && self->onSet(request, response);
            });
            service_ = node.advertiseService(options);
        },
        why);
    if (!isFine) return false;
    if (!descriptions_ || !updates_ || !service_) {
        why = "this node has a server there already, or topics of other types";
        return false;
    }
    rtt_roscomm::keepService(service_.getService());
    return true;
}

bool ServerTopics::onSet(dynamic_reconfigure::ReconfigureRequest& request,
                         dynamic_reconfigure::ReconfigureResponse& response) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (isClosed_) return false;
        ++inside_;
    }
    bool isSet = false;
    try {
        isSet = setter_(request.config, response.config);
    } catch (const std::exception& error) {
        RTT::log(RTT::Error) << "a request to change parameters failed: " << error.what() << RTT::endlog();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    --inside_;
    left_.notify_all();
    return isSet;
}

void ServerTopics::close() {
    isClosed_ = true;
    {
        std::unique_lock<std::mutex> lock(mutex_);
        left_.wait(lock, [this] { return inside_ == 0; });
    }
    if (service_) rtt_roscomm::dropService(service_.getService());
    const std::shared_ptr<ServerTopics> self = shared_from_this();
    rtt_roscomm::endWithMaster([self] {
        self->service_.shutdown();
        self->descriptions_.shutdown();
        self->updates_.shutdown();
    });
}

template <class Message>
void ServerTopics::publish(ros::Publisher& publisher, const Message& message, unsigned& last, unsigned number) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (isClosed_ || number <= last || ros::isShuttingDown()) return;
    last = number;
    publisher.publish(message);
}

void ServerTopics::publishDescription(const dynamic_reconfigure::ConfigDescription& description, unsigned number) {
    publish(descriptions_, description, lastDescription_, number);
}

void ServerTopics::publishUpdate(const dynamic_reconfigure::Config& config, unsigned number) {
    publish(updates_, config, lastUpdate_, number);
}

}  // namespace rtt_dynamic_reconfigure::detail
