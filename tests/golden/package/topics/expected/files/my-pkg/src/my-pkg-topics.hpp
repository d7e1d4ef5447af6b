#ifndef OROCOS_MY_PKG_TOPICS_HPP
#define OROCOS_MY_PKG_TOPICS_HPP

#include <string>

#include <rtt/RTT.hpp>
#include <std_msgs/Float64.h>

namespace robots {

/// Its ports are topics of ROS because deploy/my-pkg-topics.ops says so; the component itself needs no node.
class My_pkgTopics : public RTT::TaskContext {
public:
    explicit My_pkgTopics(const std::string& name);
    ~My_pkgTopics() override;

protected:
    void updateHook() override;

private:
    RTT::InputPort<std_msgs::Float64> command_;
    RTT::OutputPort<std_msgs::Float64> state_;
};

}  // namespace robots

#endif
