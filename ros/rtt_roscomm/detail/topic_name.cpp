// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/topic_name.hpp>

#include <ros/network.h>
#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt_ros/xml_rpc.hpp>
#include <rtt_roscomm/message_format.hpp>

#include <atomic>
#include <cctype>
#include <unistd.h>

namespace rtt_roscomm::detail {

namespace {

/** Letters, digits and underscores, the first one a letter. */
std::string asWord(const std::string& text) {
    std::string word = text;
    for (char& c : word)
        if (!std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80) c = '_';
    if (word.empty() || !std::isalpha(static_cast<unsigned char>(word[0]))) word.insert(0, "n");
    return word;
}

}  // namespace

std::string describe(const RTT::base::PortInterface& port) {
    return (port.asInput() ? "input port " : "output port ") + port.getFullName() + " of type " +
           port.getTypeInfo()->getTypeName();
}

std::string newTopicName(const RTT::base::PortInterface& port) {
    const RTT::DataFlowInterface* const interface = port.getInterface();
    const std::string owner = interface && interface->getOwner() ? interface->getOwner()->getName() : "port";
    static std::atomic<unsigned> made{0};  // a port may have several streams, and another one its address later
    return '/' + asWord(ros::network::getHost()) + '/' + asWord(owner) + '/' + asWord(port.getName()) + "/n" +
           std::to_string(++made) + "/p" + std::to_string(getpid());
}

std::string namespaceOf(const std::string& name) { return name.size() > 1 && name[0] == '~' ? "~" : ""; }

std::string nameWithin(const std::string& name) {
    if (namespaceOf(name).empty()) return name;
    return name.substr(name[1] == '/' ? 2 : 1);
}

std::string whyNoTopic(const std::string& name) {
    if (name.find_first_not_of('/', name[0] == '~') != std::string::npos) return "";
    if (name[0] == '~') return "it is the namespace of the node; name a topic in it, such as ~x";
    return name.empty() ? "policy.name_id is empty" : "it has slashes only; name a topic";
}

std::string whyRefused(const std::string& topic, const MessageFormat& format) {
    const ros::PublicationPtr other = ros::TopicManager::instance()->lookupPublication(topic);
    if (other && other->getMD5Sum() != format.md5())
        return "this process publishes " + other->getDataType() + " there (MD5 sum " + other->getMD5Sum() +
               "), and the port has " + format.message() + " (" + format.md5() + ")";
    return "this process has other messages there than " + format.message() + ", see the lines of ROS";
}

void warnOfOtherType(const std::string& described, const std::string& topic, const MessageFormat& format) {
    XmlRpc::XmlRpcValue request, topics;
    request[0] = ros::this_node::getName();
    if (!rtt_ros::callMaster("getTopicTypes", request, topics, std::chrono::seconds(1))) return;
    try {
        for (int i = 0; i < topics.size(); ++i) {
            const std::string other = topics[i][1];
            if (static_cast<std::string>(topics[i][0]) != topic || other == format.message() || other == "*") continue;
            RTT::log(RTT::Warning) << described << ": topic " << topic << " has messages of type " << other
                                   << " for others, and of type " << format.message()
                                   << " for this port: they do not reach each other" << RTT::endlog();
        }
    } catch (const XmlRpc::XmlRpcException&) {  // not what a master says
    }
}

void tellRefused(const std::string& described, const std::string& topic, const std::string& why) {
    RTT::log(RTT::Error) << described << " gets no stream of topic '" << topic << "': " << why << RTT::endlog();
}

}  // namespace rtt_roscomm::detail
