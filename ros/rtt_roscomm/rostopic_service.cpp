// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations of the global services `ros` and `ros.comm`, by which scripts make policies of topics, and the transport of
// types that are messages without a package of their own.
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/Plugin.hpp>
#include <rtt_roscomm/detail/open_topics.hpp>
#include <rtt_roscomm/message_table.hpp>
#include <rtt_roscomm/rostopic.h>

#include <string>

namespace {

using namespace rtt_roscomm;

void addPolicies(RTT::Service& service) {
    if (service.hasOperation("topic")) return;
    const char* const name = "Name of the topic; ~NAME is one of this node";
    service.addOperation("topic", &topic)
        .doc("The policy of a stream that sends the last sample written, or receives the last one.")
        .arg("name", name);
    service.addOperation("topicLatched", &topicLatched)
        .doc("The policy of an output stream whose last sample reaches those who come later.")
        .arg("name", name);
    service.addOperation("topicBuffer", &topicBuffer)
        .doc("The policy of a stream in which samples wait for their turn.")
        .arg("name", name)
        .arg("size", "How many may wait");
    service.addOperation("topicUnbuffered", &topicUnbuffered)
        .doc("The policy of an output stream that the writing thread itself serves; not real-time safe.")
        .arg("name", name);
    if (!service.hasAttribute("protocol_id")) service.addConstant("protocol_id", int(protocol_id));
}

/** A table of all streams of this process. */
std::string streams() {
    std::string text;
    for (const detail::TopicState& one : detail::openTopics())
        text += one.topic + " [" + one.message + "] " + one.described + ": samples " + std::to_string(one.samples) +
                ", lost " + std::to_string(one.lost) + ", connected to " + std::to_string(one.peers) + '\n';
    return text;
}

}  // namespace

ORO_PLUGIN_C_LINKAGE_BEGIN_
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component) return false;
    serveAnnouncedMessages();
    const RTT::Service::shared_ptr ros = RTT::internal::GlobalService::Instance()->provides("ros");
    const RTT::Service::shared_ptr comm = ros->provides("comm");
    addPolicies(*ros);
    addPolicies(*comm);
    if (!comm->hasOperation("streams"))
        comm->addOperation("streams", &streams)
            .doc("A line for each stream of this process: topic, message, port, samples sent or received, samples lost.");
    return true;
}
RTT_EXPORT std::string getRTTPluginName() { return "rostopic"; }
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
ORO_PLUGIN_C_LINKAGE_END_
