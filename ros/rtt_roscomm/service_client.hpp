// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The client's side of services.
#ifndef RTT_ROSCOMM_SERVICE_CLIENT_HPP
#define RTT_ROSCOMM_SERVICE_CLIENT_HPP

#include <rtt_roscomm/service_server.hpp>

#include <ros/forwards.h>
#include <ros/serialized_message.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

namespace RTT {
namespace base {
class OperationCallerBaseInvoker;
class TaskCore;
}
class ExecutionEngine;
}  // namespace RTT
namespace ros {
class ServiceServerLink;
}

namespace rtt_roscomm {

/** A request on its way. */
struct SentRequest {
    ros::SerializedMessage request, response;
    std::mutex mutex;
    std::condition_variable changed;
    bool isDone = false, isAnswered = false;
};

/**
 * A connection to a service that stays open. When it was lost, the next call asks the master again. Thread-safe; the
 * calls of several threads are executed one after another. Failures are logged: the first one, and the first after each
 * call that succeeded.
 */
class ServiceConnection : public std::enable_shared_from_this<ServiceConnection> {
public:
    /** `who` is for messages: "operation caller 'f' of component 'c'". `timeout` in seconds, 0 for none. `owner`: the
        component of the caller, or null. It lives until close(). */
    ServiceConnection(std::string resolved, ServiceType type, double timeout, std::string who,
                      const RTT::base::TaskCore* owner);
    ~ServiceConnection();

    bool isOpen() const;
    /** Blocks until the response is there, or the connection is lost or closed, or the time is over, or stop() of the
        owner waits for the call for 0.4 s: then the connection is closed and the next call opens it again, unless another
        call uses it within its own time. False, with an error logged, without a response. */
    bool call(const ros::SerializedMessage& request, ros::SerializedMessage& response);
    /** Does not wait. The first one starts a thread. Null if it is closed, or, with an error logged, if there is no
        thread to be had. */
    std::shared_ptr<SentRequest> send(const ros::SerializedMessage& request);
    /** Waits, as call() does, if `wait`. True if it is done. */
    bool finish(SentRequest& sent, bool wait);
    /** Ends calls in progress, which fail, and refuses others. */
    void close();
    /** Logs that a response could not be used. */
    void failed(const std::string& why);
    const std::string& who() const { return who_; }
    const std::string& name() const { return name_; }

private:
    typedef boost::shared_ptr<ros::ServiceServerLink> Link;
    typedef std::chrono::steady_clock Clock;
    bool callNow(const SentRequest& sent, ros::SerializedMessage& response);
    void giveUp(const SentRequest& sent, bool isEnding);
    bool isOwnerStopping() const;
    void endLostCall();
    Link connected(std::string& why);
    Link open() const;
    void work();
    void drop(const Link& link);

    const std::string name_;
    const ServiceType type_;
    const double timeout_;
    const std::string who_;
    const RTT::base::TaskCore* const owner_;
    std::mutex connecting_;  // one thread asks the master
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Link link_;
    std::deque<std::shared_ptr<SentRequest>> sent_;  // not begun
    const SentRequest* current_ = nullptr;           // that the thread executes; null if it was given up
    Clock::time_point begun_;                        // when that began
    bool is_closed_ = false, is_working_ = false, is_failing_ = false;
};

/** Puts the service behind the caller, whose signature has the form. False, with an error logged, if it has not. */
bool bindCaller(RTT::base::OperationCallerBaseInvoker& caller, const std::shared_ptr<ServiceConnection>& connection,
                Form form, RTT::ExecutionEngine* engine);

}  // namespace rtt_roscomm

#endif
