// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The server's side of services.
#ifndef RTT_ROSCOMM_SERVICE_SERVER_HPP
#define RTT_ROSCOMM_SERVICE_SERVER_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt_roscomm/service_form.hpp>

#include <ros/service_callback_helper.h>
#include <ros/service_server.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace rtt_roscomm {

/** The texts by which both ends of a connection recognise a service. */
struct ServiceType {
    std::string service;  ///< "std_srvs/SetBool"
    std::string md5;
};

/** The name of a service in ROS; "~x" is private to the node. False, with the reason, if this process is no node of ROS
    now, or if the name is malformed. */
bool resolveService(const std::string& name, std::string& resolved, std::string& why);
/** How a component imports a package of message types: "import rtt_std_srvs". */
std::string importOf(const std::string& service);

/** Answers calls. answer() is called by the threads of spinners, perhaps by several at once. */
class ServiceAnswer : public ros::ServiceCallbackHelper {
public:
    /** `what` is for messages: "operation 'f' of component 'c'". */
    explicit ServiceAnswer(std::string what) : what_(std::move(what)) {}
    /** Sends a response in any case: if answer() throws, one with the text of what it threw. */
    bool call(ros::ServiceCallbackHelperCallParams& params) final;
    void close() { is_closed_ = true; }
    const std::string& what() const { return what_; }

protected:
    virtual ros::SerializedMessage answer(const std::uint8_t* request, std::size_t size) = 0;
    /** A response with room for so many bytes, which `fill` writes. */
    static ros::SerializedMessage response(bool ok, std::size_t size, const std::function<void(std::uint8_t*)>& fill);

private:
    const std::string what_;
    std::atomic<bool> is_closed_{false};
};

/** Calls an operation by its interface. Shares ownership of the operation. */
boost::shared_ptr<ServiceAnswer> answerByOperation(const RTT::OperationInterfacePart& operation, Form form,
                                                   const std::string& what);

/** A service in the list of the master. Not thread-safe. */
class ServedService {
public:
    ServedService() = default;
    ~ServedService() { shutdown(); }
    ServedService(const ServedService&) = delete;
    ServedService& operator=(const ServedService&) = delete;

    /** Asks the master, so it blocks. False, with an error logged, if that is impossible. */
    bool advertise(const std::string& name, const ServiceType& type, boost::shared_ptr<ServiceAnswer> answer);
    /** Asks the master. Calls in progress fail for their callers; this does not wait for them, so the component that
        executes them may call it. */
    void shutdown();

private:
    boost::shared_ptr<ServiceAnswer> answer_;
    ros::ServiceServer server_;
    std::string name_;  // resolved
};

}  // namespace rtt_roscomm

#endif
