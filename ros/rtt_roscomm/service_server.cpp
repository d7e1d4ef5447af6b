// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/service_server.hpp>

#include <rtt/Logger.hpp>
#include <rtt_roscomm/detail/master_watch.hpp>
#include <rtt_roscomm/detail/topic_name.hpp>
#include <rtt_roscomm/node_state.hpp>

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <chrono>
#include <cstring>
#include <exception>
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

/** The calls that this thread answers. */
thread_local unsigned answeredByThread = 0;

ros::NodeHandle nodeOf(const std::string& name) { return ros::NodeHandle(detail::namespaceOf(name)); }

void store(std::uint8_t* to, std::size_t length) {
    for (unsigned i = 0; i != 4; ++i) to[i] = static_cast<std::uint8_t>(length >> (8 * i));
}

}  // namespace

std::string importOf(const std::string& service) { return "import rtt_" + service.substr(0, service.find('/')); }

bool resolveService(const std::string& name, std::string& resolved, std::string& why) {
    if (!isNode(why)) return false;
    why.clear();
    if (name.empty())
        why = "it is empty";
    else if (name == "~")
        why = "it is the namespace of the node; name a service in it, such as ~x";
    else if (name.back() == '/')
        why = "it ends with a slash; name a service in that namespace";
    else if (isDone([&] { resolved = nodeOf(name).resolveName(detail::nameWithin(name)); }, why))
        return true;
    why = "the name is malformed: " + why;
    return false;
}

/** A call while it is answered. */
class ServiceAnswer::Call {
public:
    explicit Call(ServiceAnswer& answer) : answer_(answer), is_counted_(answer.isExecutedHere()) {
        const std::lock_guard<std::mutex> lock(answer_.mutex_);
        if (answer_.is_closed_) throw std::runtime_error("the service was disconnected");
        if (is_counted_) ++answer_.calls_;
        ++answeredByThread;
    }
    ~Call() {
        --answeredByThread;
        if (!is_counted_) return;
        const std::lock_guard<std::mutex> lock(answer_.mutex_);
        if (--answer_.calls_ == 0) answer_.ended_.notify_all();
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

private:
    ServiceAnswer& answer_;
    const bool is_counted_;
};

ServiceAnswer::ServiceAnswer(std::string what, const RTT::OperationInterfacePart& operation)
    : what_(std::move(what)),
      operation_(boost::dynamic_pointer_cast<RTT::base::OperationCallerInterface>(operation.getLocalOperation())) {}

void ServiceAnswer::close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_closed_ = true;
}

void ServiceAnswer::waitForCalls() {
    if (answeredByThread != 0) return;
    const auto haveEnded = [this] { return calls_ == 0; };
    std::unique_lock<std::mutex> lock(mutex_);
    if (ended_.wait_for(lock, std::chrono::seconds(5), haveEnded)) return;
    lock.unlock();
    RTT::log(RTT::Warning) << what_ << " is still executed for a client of its service, and is waited for. If it does "
                           << "not end, it waits for the thread that disconnects the service: change that" << endlog();
    lock.lock();
    ended_.wait(lock, haveEnded);
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
        const Call counted(*this);
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
    ros::ServiceServer made;
    const auto refuse = [&](const std::string& reason) {
        RTT::log(RTT::Error) << "service '" << name << "' cannot be offered by " << answer->what() << ": " << reason
                             << endlog();
        return false;
    };
    if (answer_) return refuse("it is offered by " + answer_->what() + " already");
    if (!resolveService(name, resolved, why) || !isNodeReady(why)) return refuse(why);
    ros::AdvertiseServiceOptions options;
    options.service = detail::nameWithin(name);  // roscpp remaps it
    options.md5sum = type.md5;
    options.datatype = type.service;
    options.req_datatype = type.service + "Request";
    options.res_datatype = type.service + "Response";
    options.helper = answer;
    options.callback_queue = &UnwaitedQueue::instance();
    if (!isDone([&] { made = nodeOf(name).advertiseService(options); }, why)) return refuse(why);
    if (!made) return refuse("this node offers a service of that name already");
    detail::MasterWatch::instance().addService(made.getService());
    name_ = made.getService();
    server_ = made;
    answer_ = std::move(answer);
    return true;
}

void ServedService::shutdown() {
    if (!answer_) return;
    answer_->close();
    detail::MasterWatch::instance().removeService(name_);
    endWithMaster([server = server_]() mutable { server.shutdown(); });
    server_ = {};
    answer_->waitForCalls();
    answer_.reset();
}

}  // namespace rtt_roscomm
