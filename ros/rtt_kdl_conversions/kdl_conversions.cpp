// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Typekit KDLConversions: no types, but the global service `KDL`, by which scripts convert messages into the classes of KDL and
// back. The typekit of those classes is another package.
#include <kdl_conversions/kdl_msg.h>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/types/TypekitPlugin.hpp>

#include <string>

namespace {

/** Makes of a function with a result parameter one that returns the result. */
template <class From, class To, void (*convert)(const From&, To&)>
To converted(const From& from) {
    To to;
    convert(from, to);
    return to;
}

template <class Message, class Class, void (*toKdl)(const Message&, Class&), void (*toMessage)(const Class&, Message&)>
void addPair(RTT::Service& service, const std::string& name, const std::string& message, const std::string& kdl) {
    if (service.hasOperation(name + "MsgToKDL")) return;
    service.addOperation(name + "MsgToKDL", &converted<Message, Class, toKdl>)
        .doc("The " + kdl + " of a message.")
        .arg("message", message);
    service.addOperation(name + "KDLToMsg", &converted<Class, Message, toMessage>)
        .doc("The message of a " + kdl + ".")
        .arg("value", kdl);
}

class KdlConversions : public RTT::types::TypekitPlugin {
public:
    bool loadTypes() override {
        const RTT::Service::shared_ptr kdl = RTT::internal::GlobalService::Instance()->provides("KDL");
        addPair<geometry_msgs::Point, KDL::Vector, tf::pointMsgToKDL, tf::pointKDLToMsg>(*kdl, "point", "geometry_msgs/Point",
                                                                                        "KDL::Vector");
        addPair<geometry_msgs::Pose, KDL::Frame, tf::poseMsgToKDL, tf::poseKDLToMsg>(*kdl, "pose", "geometry_msgs/Pose",
                                                                                    "KDL::Frame");
        addPair<geometry_msgs::Quaternion, KDL::Rotation, tf::quaternionMsgToKDL, tf::quaternionKDLToMsg>(
            *kdl, "quaternion", "geometry_msgs/Quaternion", "KDL::Rotation");
        addPair<geometry_msgs::Transform, KDL::Frame, tf::transformMsgToKDL, tf::transformKDLToMsg>(
            *kdl, "transform", "geometry_msgs/Transform", "KDL::Frame");
        addPair<geometry_msgs::Twist, KDL::Twist, tf::twistMsgToKDL, tf::twistKDLToMsg>(*kdl, "twist", "geometry_msgs/Twist",
                                                                                       "KDL::Twist");
        addPair<geometry_msgs::Vector3, KDL::Vector, tf::vectorMsgToKDL, tf::vectorKDLToMsg>(
            *kdl, "vector", "geometry_msgs/Vector3", "KDL::Vector");
        addPair<geometry_msgs::Wrench, KDL::Wrench, tf::wrenchMsgToKDL, tf::wrenchKDLToMsg>(
            *kdl, "wrench", "geometry_msgs/Wrench", "KDL::Wrench");
        return true;
    }
    bool loadOperators() override { return true; }
    bool loadConstructors() override { return true; }
    std::string getName() override { return "KDLConversions"; }
};

}  // namespace

ORO_TYPEKIT_PLUGIN(KdlConversions)
