// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_tf/detail/tf_component.hpp>

#include <ros/names.h>
#include <ros/this_node.h>
#include <rtt/Component.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt_ros/xml_rpc.hpp>
#include <rtt_roscomm/node_state.hpp>
#include <rtt_roscomm/rostopic.h>
#include <rtt_tf/detail/frame_names.hpp>
#include <rtt_tf/detail/transform_check.hpp>
#include <xmlrpcpp/XmlRpcValue.h>

#include <boost/make_shared.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace rtt_tf {

using detail::Transforms;
using tf2_msgs::TFMessage;

namespace {

constexpr double kLongestCache = 1e9;
constexpr double kLargestBuffer = 1e6;
/** Beside the kinds of Refusal, for the ports. */
constexpr unsigned kFull = 1 << 16, kNotConnected = 1 << 17, kNotConfigured = 1 << 18;

std::string portOf(const std::string& target, const std::string& source) {
    return "tracker_tf_" + source + '_' + target;
}

}  // namespace

RTT_TF::RTT_TF(const std::string& name)
    : TaskContext(name, PreOperational),
      in_("tf_in"),
      staticIn_("tf_static_in"),
      out_("tf_out"),
      staticOut_("tf_static_out"),
      transforms_(boost::make_shared<Transforms>(name)) {
    addProperty("cache_time", cacheTime_).doc("For how long transforms are kept. [s]");
    addProperty("buffer_size", bufferSize_).doc("How many messages wait for this component at each port.");
    addProperty("tf_prefix", prefixProperty_)
        .doc("Goes in front of the frames that are broadcast. A parameter tf_prefix of the node, or above it, replaces "
             "this when the component is configured.");
    addEventPort(in_).doc("Transforms, from /tf.");
    addEventPort(staticIn_).doc("Transforms that never change, from /tf_static.");
    addPort(out_).doc("Transforms that are broadcast, to /tf.");
    addPort(staticOut_).doc("All static transforms that were broadcast, to /tf_static.");
    addOperations(*provides());
    addOperations(*provides("tf"));
    provides("tf")->doc("Lookup and broadcast of transforms.");
}

RTT_TF::~RTT_TF() {
    stopForGood();
    closeStreams();
}

void RTT_TF::addOperations(RTT::Service& service) {
    const char* const target = "Frame into which data are brought";
    const char* const source = "Frame of the data";
    const char* const time = "Time of the transform; 0 is the last one known";
    service.addOperation("lookupTransform", &Transforms::lookupLast, transforms_)
        .doc("The last transform between two frames. It has no frames if there is none, which is logged.")
        .arg("target", target)
        .arg("source", source);
    service.addOperation("lookupTransformAtTime", &Transforms::lookupAtTime, transforms_)
        .doc("The transform between two frames at a time. It has no frames if there is none, which is logged.")
        .arg("target", target)
        .arg("source", source)
        .arg("common_time", time);
    service.addOperation("canTransform", &Transforms::canLast, transforms_)
        .doc("Is there a transform between the two frames?")
        .arg("target", target)
        .arg("source", source);
    service.addOperation("canTransformAtTime", &Transforms::canAtTime, transforms_)
        .doc("Is there a transform between the two frames at that time?")
        .arg("target", target)
        .arg("source", source)
        .arg("common_time", time);
    service.addOperation("broadcastTransform", &RTT_TF::broadcast, this, RTT::OwnThread)
        .doc("Sends a transform to /tf, with tf_prefix in front of its frames.")
        .arg("transform", "From header.frame_id to child_frame_id");
    service.addOperation("broadcastTransforms", &RTT_TF::broadcastAll, this, RTT::OwnThread)
        .doc("Sends several transforms to /tf in one message, with tf_prefix in front of their frames.")
        .arg("transforms", "From header.frame_id to child_frame_id");
    service.addOperation("broadcastStaticTransform", &RTT_TF::broadcastStatic, this, RTT::OwnThread)
        .doc("Sends a transform that does not change to /tf_static, also to those who listen later.")
        .arg("transform", "From header.frame_id to child_frame_id");
    service.addOperation("broadcastStaticTransforms", &RTT_TF::broadcastAllStatic, this, RTT::OwnThread)
        .doc("Sends transforms that do not change to /tf_static, also to those who listen later.")
        .arg("transforms", "From header.frame_id to child_frame_id");
    service.addOperation("subscribeTransform", &RTT_TF::subscribe, this, RTT::OwnThread)
        .doc("Adds the output port tracker_tf_SOURCE_TARGET, which gets the last transform at each update. True if there "
             "is one already.")
        .arg("target", target)
        .arg("source", source);
    service.addOperation("listTrackers", &RTT_TF::listTrackers, this, RTT::OwnThread)
        .doc("A line for each port that subscribeTransform() made.");
}

bool RTT_TF::configureHook() {
    cleanupHook();  // it may be configured again
    std::string why;
    if (!checkProperties(why) || !checkTypes(why) || !rtt_roscomm::isNodeReady(why) || !findPrefix(why)) {
        RTT::log(RTT::Error) << getName() << ": cannot be configured: " << why << RTT::endlog();
        return false;
    }
    transforms_->open(ros::Duration(cacheTime_));
    refused_.clear();
    last_ = ros::Time();
    if (openStreams()) return true;
    cleanupHook();
    return false;
}

bool RTT_TF::checkProperties(std::string& why) const {
    if (!(cacheTime_ > 0 && cacheTime_ <= kLongestCache))
        why = "property cache_time is " + std::to_string(cacheTime_) + "; it must be above 0, and at most 1e9 s";
    else if (!(bufferSize_ >= 1 && bufferSize_ <= kLargestBuffer))
        why = "property buffer_size is " + std::to_string(bufferSize_) + "; it must be from 1 to 1000000";
    return why.empty();
}

bool RTT_TF::checkTypes(std::string& why) const {
    if (!in_.getTypeInfo()->hasProtocol(ORO_ROS_PROTOCOL_ID)) {
        why = "the type /tf2_msgs/TFMessage, or its transport, is unknown; import(\"rtt_tf2_msgs\") first";
        return false;
    }
    using namespace RTT::internal;
    if (DataSourceTypeInfo<Stamped>::getTypeInfo() == DataSourceTypeInfo<UnknownType>::getTypeInfo())
        RTT::log(RTT::Warning) << getName()
                               << ": the type /geometry_msgs/TransformStamped is unknown, so scripts cannot use "
                                  "transforms; import(\"rtt_geometry_msgs\")"
                               << RTT::endlog();
    return true;
}

bool RTT_TF::findPrefix(std::string& why) {
    // roscpp's own calls have no time limit.
    constexpr std::chrono::seconds limit(1);
    std::string name = "tf_prefix";
    const auto& others = ros::names::getUnresolvedRemappings();
    if (const auto other = others.find(name); other != others.end()) name = other->second;
    XmlRpc::XmlRpcValue request, key, value;
    request[0] = ros::this_node::getName();  // where the search begins
    request[1] = name;
    if (rtt_ros::callMaster("searchParam", request, key, limit) && key.getType() == XmlRpc::XmlRpcValue::TypeString) {
        request[1] = key;
        if (rtt_ros::callMaster("getParam", request, value, limit)) {
            if (value.getType() != XmlRpc::XmlRpcValue::TypeString) {
                why = "parameter " + static_cast<std::string>(key) + " is no string; set it to a text, or delete it";
                return false;
            }
            prefixProperty_ = static_cast<std::string>(value);
        }
    }
    // Without an answer, there is no telling whether it is set.
    if (!value.valid() && !rtt_roscomm::isNodeReady(why)) return false;
    const Lock lock(mutex_);
    prefix_ = detail::trimmed(prefixProperty_);
    return true;
}

bool RTT_TF::openStreams() {
    for (const Stream& stream : streams())
        if (!stream.port->createStream(stream.policy)) return false;
    return true;
}

std::vector<RTT_TF::Stream> RTT_TF::streams() {
    const int size = static_cast<int>(bufferSize_);
    return {{&in_, rtt_roscomm::topicBuffer("/tf", size)},
            {&staticIn_, rtt_roscomm::topicBuffer("/tf_static", size)},
            {&out_, rtt_roscomm::topicBuffer("/tf", size)},
            {&staticOut_, rtt_roscomm::topicLatched("/tf_static")}};
}

// Connections that others have made stay.
void RTT_TF::closeStreams() {
    const std::pair<RTT::base::PortInterface*, const char*> streams[] = {
        {&in_, "/tf"}, {&staticIn_, "/tf_static"}, {&out_, "/tf"}, {&staticOut_, "/tf_static"}};
    for (const auto& [port, topic] : streams)
        for (const auto& connection : port->getManager()->getConnections())
            if (connection.get<2>().transport == ORO_ROS_PROTOCOL_ID && connection.get<2>().name_id == topic)
                (void)port->getManager()->removeConnection(connection.get<0>().get());
}

void RTT_TF::cleanupHook() {
    closeStreams();
    transforms_->close();
    const Lock lock(mutex_);
    allStatic_.transforms.clear();
}

void RTT_TF::updateHook() {
    lookAtTime();
    while (staticIn_.read(received_, false) == RTT::NewData) transforms_->insert(received_, true);
    while (in_.read(received_, false) == RTT::NewData) transforms_->insert(received_, false);
    Stamped found;
    for (const auto& tracker : trackers_)
        if (transforms_->track(tracker->target, tracker->source, found)) (void)tracker->port.write(found);
}

// Where time was set back, as a recording does that begins again, old transforms would be in the future.
void RTT_TF::lookAtTime() {
    if (!ros::Time::isValid()) return;
    const ros::Time now = ros::Time::now();
    if (now < last_) {
        RTT::log(RTT::Warning) << getName() << ": time went back by " << (last_ - now).toSec()
                               << " s; all transforms but the static ones are forgotten" << RTT::endlog();
        transforms_->forgetMoving();
        in_.clear();
    }
    last_ = now;
}

std::string RTT_TF::prefixNow() const {
    const Lock lock(mutex_);
    return prefix_;
}

TFMessage RTT_TF::accepted(const std::vector<Stamped>& transforms) {
    TFMessage message;
    if (!isConfigured()) {
        if (refused_.isNew("", kNotConfigured))
            RTT::log(RTT::Error) << getName() << ": cannot broadcast: call configure() first" << RTT::endlog();
        return message;
    }
    const std::string prefix = prefixNow();
    for (Stamped one : transforms) {
        one.header.frame_id = detail::prefixed(prefix, one.header.frame_id);
        one.child_frame_id = detail::prefixed(prefix, one.child_frame_id);
        if (const detail::Refusal refusal = detail::check(one)) {
            if (refused_.isNew(one.child_frame_id, refusal.kind))
                RTT::log(RTT::Error) << getName() << ": a transform is not broadcast: " << refusal.text << RTT::endlog();
            continue;
        }
        if (!refused_.isEmpty()) refused_.works(one.child_frame_id);
        message.transforms.push_back(std::move(one));
    }
    return message;
}

void RTT_TF::send(RTT::OutputPort<TFMessage>& port, const TFMessage& message) {
    if (message.transforms.empty()) return;
    const RTT::WriteStatus status = port.write(message);
    if (status == RTT::WriteSuccess) {
        if (!refused_.isEmpty()) refused_.works(port.getName());
        return;
    }
    const bool isFull = status == RTT::WriteFailure;
    if (refused_.isNew(port.getName(), isFull ? kFull : kNotConnected))
        RTT::log(RTT::Error) << getName() << ": the transform to frame '" << message.transforms[0].child_frame_id
                             << "' is not broadcast: port " << port.getName()
                             << (isFull ? " is full; set property buffer_size" : " is not connected") << RTT::endlog();
}

void RTT_TF::broadcastAll(const std::vector<Stamped>& transforms) { send(out_, accepted(transforms)); }

// A topic keeps its last message for those who come later, so each message has all.
void RTT_TF::broadcastAllStatic(const std::vector<Stamped>& transforms) {
    TFMessage fresh = accepted(transforms);
    if (!fresh.transforms.empty()) send(staticOut_, withAllStatic(std::move(fresh)));
}

TFMessage RTT_TF::withAllStatic(TFMessage fresh) {
    const Lock lock(mutex_);
    for (Stamped& one : fresh.transforms) {
        const auto same = [&](const Stamped& other) { return other.child_frame_id == one.child_frame_id; };
        const auto old = std::find_if(allStatic_.transforms.begin(), allStatic_.transforms.end(), same);
        if (old == allStatic_.transforms.end())
            allStatic_.transforms.push_back(std::move(one));
        else
            *old = std::move(one);
    }
    return allStatic_;
}

bool RTT_TF::subscribe(const std::string& target, const std::string& source) {
    const std::string to = detail::bare(target), from = detail::bare(source), name = portOf(to, from);
    for (const auto& tracker : trackers_)
        if (tracker->target == to && tracker->source == from) return true;
    if (to.empty() || from.empty() || getPort(name) || provides()->hasService(name)) {
        RTT::log(RTT::Error) << getName() << ": cannot subscribe to the transform to '" << target << "' from '" << source
                             << "': "
                             << (to.empty() || from.empty() ? "the name of a frame is empty"
                                                            : "there is another port or service '" + name + "'")
                             << RTT::endlog();
        return false;
    }
    auto made = std::make_unique<Tracker>();
    made->target = to;
    made->source = from;
    addPort(name, made->port).doc("The transform to frame '" + to + "' from frame '" + from + "'.");
    trackers_.push_back(std::move(made));
    return true;
}

std::string RTT_TF::listTrackers() {
    std::string text;
    for (const auto& tracker : trackers_)
        text += tracker->port.getName() + ": to '" + tracker->target + "' from '" + tracker->source + "'\n";
    return text;
}

}  // namespace rtt_tf

ORO_CREATE_COMPONENT(rtt_tf::RTT_TF)
