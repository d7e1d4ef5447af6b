// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/service_server.hpp>

#include <rtt/Logger.hpp>
#include <rtt_roscomm/detail/master_watch.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <chrono>
#include <cstring>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace rtt_roscomm {

namespace {

using RTT::endlog;

/**
 * The queue of all spinners, except that a service that ends does not wait there for its calls in progress: it would
 * wait forever in the thread of the component that has to execute such a call.
 */
class UnwaitedQueue final : public ros::CallbackQueueInterface {
public:
    void addCallback(const ros::CallbackInterfacePtr& callback, uint64_t) override {
        ros::getGlobalCallbackQueue()->addCallback(callback, reinterpret_cast<std::uintptr_t>(this));
    }
    void removeByID(uint64_t) override {}

    /** Never destroyed: threads of roscpp may use it until the process ends. */
    static UnwaitedQueue& instance() {
        static auto* const queue = new UnwaitedQueue();
        return *queue;
    }
};

void store(std::uint8_t* to, std::size_t length) {
    for (unsigned i = 0; i != 4; ++i) to[i] = static_cast<std::uint8_t>(length >> (8 * i));
}

}  // namespace

std::string importOf(const std::string& service) { return "import rtt_" + service.substr(0, service.find('/')); }

bool resolveService(const std::string& name, std::string& resolved, std::string& why) {
    if (!isNode(why)) return false;
    try {
        if (name.empty() || name == "~" || name.back() == '/') throw ros::InvalidNameException("the name is empty");
        resolved = ros::names::resolve(name);
        return true;
    } catch (const ros::Exception& error) {
        why = std::string("the name is malformed: ") + error.what();
        return false;
    }
}

ros::SerializedMessage ServiceAnswer::response(bool ok, std::size_t size,
                                               const std::function<void(std::uint8_t*)>& fill) {
    if (size > UINT32_MAX - 5) throw std::runtime_error("the response has more than 4 GB");
    ros::SerializedMessage message(boost::shared_array<std::uint8_t>(new std::uint8_t[size + 5]), size + 5);
    message.buf[0] = ok;
    store(message.buf.get() + 1, size);
    fill(message.buf.get() + 5);
    return message;
}

bool ServiceAnswer::call(ros::ServiceCallbackHelperCallParams& params) {
    std::string problem;
    try {
        if (is_closed_) throw std::runtime_error("the service was disconnected");
        const ros::SerializedMessage& request = params.request;
        const auto head =
            request.message_start ? static_cast<std::size_t>(request.message_start - request.buf.get()) : 0;
        params.response = answer(request.buf.get() + head, request.num_bytes - head);
        return true;
    } catch (const std::exception& error) {
        problem = error.what();
    } catch (...) {
        problem = "something was thrown that is no std::exception";
    }
    problem = what_ + ": " + problem;
    // True, because roscpp replaces the response of a call that gives false by one without a text.
    params.response =
        response(false, problem.size(), [&](std::uint8_t* to) { std::memcpy(to, problem.data(), problem.size()); });
    return true;
}

bool ServedService::advertise(const std::string& name, const ServiceType& type,
                              boost::shared_ptr<ServiceAnswer> answer) {
    std::string why, resolved;
    const auto refuse = [&](const std::string& reason) {
        RTT::log(RTT::Error) << "service '" << name << "' cannot be offered by " << answer->what() << ": " << reason
                             << endlog();
        return false;
    };
    if (!resolveService(name, resolved, why) || !isNodeReady(why)) return refuse(why);
    ros::AdvertiseServiceOptions options;
    options.service = resolved;
    options.md5sum = type.md5;
    options.datatype = type.service;
    options.req_datatype = type.service + "Request";
    options.res_datatype = type.service + "Response";
    options.helper = answer;
    options.callback_queue = &UnwaitedQueue::instance();
    try {
        ros::NodeHandle node;
        server_ = node.advertiseService(options);
    } catch (const std::exception& error) {
        return refuse(error.what());
    }
    if (!server_) return refuse("this node offers a service of that name already");
    answer_ = std::move(answer);
    name_ = resolved;
    detail::MasterWatch::instance().addService(name_);
    return true;
}

void ServedService::shutdown() {
    if (!answer_) return;
    answer_->close();
    detail::MasterWatch::instance().removeService(name_);
    doWithin([server = server_]() mutable { server.shutdown(); }, std::chrono::seconds(2));
    server_ = {};
    answer_.reset();
}

}  // namespace rtt_roscomm
