// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The server's side of services.
#ifndef RTT_ROSCOMM_SERVICE_SERVER_HPP
#define RTT_ROSCOMM_SERVICE_SERVER_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt_roscomm/service_form.hpp>

#include <ros/service_callback_helper.h>
#include <ros/service_server.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace rtt_roscomm {

/** The texts by which both ends of a connection recognise a service. */
struct ServiceType {
    std::string service;  ///< "std_srvs/SetBool"
    std::string md5;
};

/** The name of a service in ROS after remapping, as advertise() gives it; "~x" is private to the node. False, with the
    reason, if this process is no node of ROS now, or if the name is malformed. */
bool resolveService(const std::string& name, std::string& resolved, std::string& why);
/** How a component imports a package of message types: "import rtt_std_srvs". */
std::string importOf(const std::string& service);

/** Answers calls. answer() is called by the threads of spinners, perhaps by several at once. */
class ServiceAnswer : public ros::ServiceCallbackHelper {
public:
    /** `what` is for messages: "operation 'f' of component 'c'". The operation is the one that answer() calls. */
    ServiceAnswer(std::string what, const RTT::OperationInterfacePart& operation);
    /** Sends a response in any case: if answer() throws, one with the text of what it threw. */
    bool call(ros::ServiceCallbackHelperCallParams& params) final;
    /** Refuses calls from now on. */
    void close();
    /** After close(): waits until no other thread executes the operation itself. Calls that wait for the component's
        thread are not waited for, because that may be the calling one. Does not wait in a thread that answers a call:
        two of them would wait for each other. */
    void waitForCalls();
    const std::string& what() const { return what_; }

protected:
    virtual ros::SerializedMessage answer(const std::uint8_t* request, std::size_t size) = 0;
    /** A response with room for so many bytes, which `fill` writes. */
    static ros::SerializedMessage response(bool ok, std::size_t size, const std::function<void(std::uint8_t*)>& fill);

private:
    class Call;
    bool isExecutedHere() const { return operation_ && operation_->getThread() == RTT::ClientThread; }

    const std::string what_;
    const RTT::base::OperationCallerInterface::shared_ptr operation_;  // null if it is not in this process
    std::mutex mutex_;
    std::condition_variable ended_;
    unsigned calls_ = 0;  // that execute the operation
    bool is_closed_ = false;
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

    /** Asks the master, so it blocks. False, with an error logged, if that is impossible, or if it is advertised. */
    bool advertise(const std::string& name, const ServiceType& type, boost::shared_ptr<ServiceAnswer> answer);
    /** Asks the master. Calls in progress fail for their callers. Waits for them as ServiceAnswer::waitForCalls(). */
    void shutdown();

private:
    boost::shared_ptr<ServiceAnswer> answer_;
    ros::ServiceServer server_;
    std::string name_;  // resolved
};

}  // namespace rtt_roscomm

#endif
