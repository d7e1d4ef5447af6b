// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DYNAMIC_RECONFIGURE_DETAIL_SERVER_TOPICS_HPP
#define RTT_DYNAMIC_RECONFIGURE_DETAIL_SERVER_TOPICS_HPP

#include <dynamic_reconfigure/ConfigDescription.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace rtt_dynamic_reconfigure::detail {

/** The service and the two topics of a server. It outlives its server while roscpp is busy with it. */
class ServerTopics : public std::enable_shared_from_this<ServerTopics> {
public:
    typedef std::function<bool(const dynamic_reconfigure::Config& request, dynamic_reconfigure::Config& response)> Setter;

    /** In that namespace. Null, with the reason, if that fails. `setter` is called in threads of roscpp, several at a
        time, from start() on. */
    static std::shared_ptr<ServerTopics> open(const std::string& ns, Setter setter, std::string& why);
    ~ServerTopics();

    /** Calls are refused before it, because the first description has not been published yet. */
    void start() { isClosed_ = false; }
    /** Returns when no thread is within the setter, except, perhaps, this one. */
    void close();
    /** Calls are refused. */
    const std::atomic<bool>& isClosed() const { return isClosed_; }

    /** Nothing that is older than what was published already. */
    void publishDescription(const dynamic_reconfigure::ConfigDescription& description, unsigned number);
    void publishUpdate(const dynamic_reconfigure::Config& config, unsigned number);

private:
    explicit ServerTopics(Setter setter) : setter_(std::move(setter)) {}
    bool advertise(const std::string& ns, std::string& why);
    bool onSet(dynamic_reconfigure::ReconfigureRequest& request, dynamic_reconfigure::ReconfigureResponse& response);
    template <class Message>
    void publish(ros::Publisher& publisher, const Message& message, unsigned& last, unsigned number);

    const Setter setter_;
    std::atomic<bool> isClosed_{true};
    std::mutex mutex_;  // guards what follows
    std::condition_variable left_;
    unsigned inside_ = 0, lastDescription_ = 0, lastUpdate_ = 0;
    ros::ServiceServer service_;
    ros::Publisher descriptions_, updates_;
};

}  // namespace rtt_dynamic_reconfigure::detail

#endif
