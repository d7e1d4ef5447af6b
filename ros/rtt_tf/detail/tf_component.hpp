// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_TF_DETAIL_TF_COMPONENT_HPP
#define RTT_TF_DETAIL_TF_COMPONENT_HPP

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_tf/detail/reported.hpp>
#include <rtt_tf/detail/transforms.hpp>
#include <tf2_msgs/TFMessage.h>

#include <boost/shared_ptr.hpp>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace rtt_tf {

/**
 * Listens to /tf and /tf_static, answers lookups, and broadcasts.
 *
 * Lookups are executed by their callers, in any thread. The component's thread receives, broadcasts and serves the
 * trackers. Transforms arrive only while it is running.
 */
class RTT_TF : public RTT::TaskContext {
public:
    typedef geometry_msgs::TransformStamped Stamped;

    explicit RTT_TF(const std::string& name);
    ~RTT_TF() override;

protected:
    bool configureHook() override;
    void updateHook() override;
    void cleanupHook() override;

private:
    typedef std::lock_guard<std::mutex> Lock;
    struct Tracker {
        std::string target, source;
        RTT::OutputPort<Stamped> port;
    };
    struct Stream {
        RTT::base::PortInterface* port;
        RTT::ConnPolicy policy;
    };

    void addOperations(RTT::Service& service);
    // Operations of this thread:
    void broadcast(const Stamped& transform) { broadcastAll({transform}); }
    void broadcastAll(const std::vector<Stamped>& transforms);
    void broadcastStatic(const Stamped& transform) { broadcastAllStatic({transform}); }
    void broadcastAllStatic(const std::vector<Stamped>& transforms);
    bool subscribe(const std::string& target, const std::string& source);
    std::string listTrackers();

    bool checkProperties(std::string& why) const;
    bool checkTypes(std::string& why) const;
    bool findPrefix(std::string& why);
    std::vector<Stream> streams();
    bool openStreams();
    void closeStreams();
    std::string prefixNow() const;
    tf2_msgs::TFMessage withAllStatic(tf2_msgs::TFMessage fresh);
    tf2_msgs::TFMessage accepted(const std::vector<Stamped>& transforms);
    void send(RTT::OutputPort<tf2_msgs::TFMessage>& port, const tf2_msgs::TFMessage& message);
    void lookAtTime();

    double cacheTime_ = 10, bufferSize_ = 100;
    std::string prefixProperty_;
    RTT::InputPort<tf2_msgs::TFMessage> in_, staticIn_;
    RTT::OutputPort<tf2_msgs::TFMessage> out_, staticOut_;
    // Lookups share it, which may go on in other threads when this component is destroyed.
    const boost::shared_ptr<detail::Transforms> transforms_;
    std::vector<std::unique_ptr<Tracker>> trackers_;
    tf2_msgs::TFMessage received_;
    // Broadcasts use them, which may be executed while another thread configures this component.
    mutable std::mutex mutex_;
    std::string prefix_;
    tf2_msgs::TFMessage allStatic_;
    ros::Time last_;
    detail::Reported refused_;
};

}  // namespace rtt_tf

#endif
