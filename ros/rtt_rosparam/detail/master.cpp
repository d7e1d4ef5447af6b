// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "master.hpp"

#include "read_value.hpp"
#include "xml_value.hpp"

#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <rtt_ros/xml_rpc.hpp>

#include <chrono>
#include <cstdint>
#include <mutex>

namespace rtt_rosparam::master {

typedef XmlRpc::XmlRpcValue Value;

namespace {

constexpr std::chrono::milliseconds kLimit(static_cast<int>(kPatience * 1000));

Value call(const char* method, const Value& arguments) {
    Value result;
    const std::string why =
        rtt_ros::callXmlRpc(ros::master::getHost(), ros::master::getPort(), method, arguments, result, kLimit);
    if (why.rfind("it refuses", 0) == 0)
        throw Failure("the ROS master at " + ros::master::getURI() + " does not take a call: " + why +
                      "; is ROS_MASTER_URI that of a roscore?");
    if (!why.empty())
        throw Failure("the ROS master at " + ros::master::getURI() + " does not answer: " + why +
                      "; start roscore, or set ROS_MASTER_URI");
    return result;
}

Value arguments(const std::string& name) {
    if (!ros::isInitialized())
        throw Failure("this process is not a ROS node; import rtt_rosnode before, or call ros::init()");
    Value made;
    made[0] = ros::this_node::getName();
    if (!name.empty()) made[1] = name;
    return made;
}

struct Answer {
    int code;
    std::string text;
    Value value;
};

[[noreturn]] void notUnderstood() {
    throw Failure("the ROS master at " + ros::master::getURI() + " gives an answer that is not understood");
}

Answer answerIn(const Value& result) {
    if (result.getType() != Value::TypeArray || result.size() != 3 || result[0].getType() != Value::TypeInt ||
        result[1].getType() != Value::TypeString)
        notUnderstood();
    return {as<int>(result[0]), as<std::string>(result[1]), result[2]};
}

/** Members one by one: a struct would replace what is there. */
void flatten(const std::string& name, const Value& value, Parameters& parts) {
    if (value.getType() == Value::TypeStruct) {
        const std::string below = name == "/" ? name : name + '/';
        for (const auto& member : value) flatten(below + member.first, member.second, parts);
        Value there;
        if (value.size() != 0 || (get(name, there) && there.getType() == Value::TypeStruct)) return;
    }
    parts.emplace_back(name, value);
}

void add(Value& calls, const char* method, const Parameters::value_type& parameter) {
    Value its = arguments(parameter.first);
    its[2] = parameter.second;
    Value& entry = calls[calls.valid() ? calls.size() : 0];
    entry["methodName"] = method;
    entry["params"] = its;
}

/** The master tells a node about what others change, but not about what it sets itself. If it did, an older notice could
    come after this one. */
void tellCache(const Value& updates) {
    if (!ros::isStarted() || !updates.valid()) return;
    std::string host;
    std::uint32_t port = 0;
    Value all, result;
    all[0] = updates;
    const std::string why = ros::network::splitURI(ros::XMLRPCManager::instance()->getServerURI(), host, port)
                                ? rtt_ros::callXmlRpc(host, port, "system.multicall", all, result, kLimit)
                                : "it has no address";
    if (!why.empty())
        throw Failure("parameters are set, but this node does not take note of it: " + why +
                      "; properties that are parameters may have old values");
}

/** Returns what the master refuses: "parameter 'a': …". */
std::string setSome(Parameters::const_iterator first, Parameters::const_iterator last) {
    Value calls;
    for (auto one = first; one != last; ++one) add(calls, "setParam", *one);
    Value all;
    all[0] = calls;
    const Value results = call("system.multicall", all);
    if (results.getType() != Value::TypeArray || results.size() != calls.size()) notUnderstood();
    std::string refused;
    Value updates;
    for (int i = 0; i != results.size(); ++i) {
        // In an array of its own, or a struct that says what is wrong.
        const bool isStruct = results[i].getType() == Value::TypeStruct;
        if (!isStruct && (results[i].getType() != Value::TypeArray || results[i].size() != 1)) notUnderstood();
        const Answer answer =
            isStruct ? Answer{0, results[i].toXml(), {}} : answerIn(results[i][0]);
        if (answer.code == 1)
            add(updates, "paramUpdate", *(first + i));
        else
            refused += (refused.empty() ? "parameter '" : "; parameter '") + (first + i)->first + "': " + answer.text;
    }
    tellCache(updates);
    return refused;
}

}  // namespace

bool get(const std::string& name, Value& value) {
    const Answer answer = answerIn(call("getParam", arguments(name)));
    if (answer.code == 1) value = answer.value;
    if (answer.code == 0) throw Failure("the ROS master cannot read parameter '" + name + "': " + answer.text);
    return answer.code == 1;
}

void set(const Parameters& parameters) {
    Parameters parts;
    for (const auto& [name, value] : parameters) flatten(name, value, parts);
    // Master and cache must get values in one order.
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    constexpr std::ptrdiff_t kMost = 1000;
    std::string refused;
    for (auto first = parts.cbegin(); first != parts.cend();) {
        const auto last = parts.cend() - first > kMost ? first + kMost : parts.cend();
        const std::string more = setSome(first, last);
        refused += (refused.empty() || more.empty() ? "" : "; ") + more;
        first = last;
    }
    if (!refused.empty()) throw Failure("the ROS master at " + ros::master::getURI() + " does not set " + refused);
}

void check() { (void)call("getPid", arguments("")); }

}  // namespace rtt_rosparam::master
