// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_TF_FRAMES_HPP
#define OROFORGE_TESTS_ROS_TF_FRAMES_HPP

#include <ros_topic/node.hpp>

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <rtt/OperationCaller.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_tf/tf_interface.h>

#include <gtest/gtest.h>

#include <string>

namespace ros_test {

/** At x, of now or another time. */
geometry_msgs::TransformStamped moved(const std::string& frame, const std::string& child, double x,
                                      const ros::Time& time = ros::Time::now());

/** Makes the types of messages known that typekits bring otherwise. */
void addMessageTypes();

/** A component "tf" of the type rtt_tf::RTT_TF, as a deployment loads it, and one that uses it. */
class Frames : public testing::Test {
protected:
    Frames();
    ~Frames() override;
    bool start() { return tf->configure() && tf->start(); }
    template <class T>
    void set(const std::string& name, const T& value) {
        static_cast<RTT::Property<T>*>(tf->getProperty(name))->set(value);
    }
    /** The x of the transform; NaN if there is none. */
    double x(const std::string& target, const std::string& source);
    /** Waits for it. */
    bool isAt(double expected, const std::string& target, const std::string& source);

    Node node;
    RTT::TaskContext* tf = nullptr;
    RTT::TaskContext user{"user"};
    rtt_tf::TFInterface calls{&user};
};

}  // namespace ros_test

#endif
