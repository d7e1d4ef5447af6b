// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "master.hpp"

#include "read_value.hpp"
#include "xml_value.hpp"

#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <rtt_ros/xml_rpc.hpp>

#include <chrono>

namespace rtt_rosparam::master {

typedef XmlRpc::XmlRpcValue Value;

namespace {

Value call(const char* method, const Value& arguments) {
    Value result;
    const std::string why =
        rtt_ros::callXmlRpc(ros::master::getHost(), ros::master::getPort(), method, arguments, result,
                            std::chrono::milliseconds(static_cast<int>(kPatience * 1000)));
    if (!why.empty())
        throw Failure("the ROS master at " + ros::master::getURI() + " does not answer: " + why +
                      "; start roscore, or set ROS_MASTER_URI");
    return result;
}

Value arguments(const std::string& name) {
    if (!ros::isInitialized())
        throw Failure("this process is not a ROS node; import rtt_rosnode before, or call ros::init()");
    Value made;
    // Not the name of the node: the master does not tell a node about what it changed itself, and roscpp's cache would
    // keep the old value.
    made[0] = ros::this_node::getName() + "/rosparam";
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

void setSome(Parameters::const_iterator first, Parameters::const_iterator last) {
    Value calls;
    int count = 0;
    for (auto one = first; one != last; ++one) {
        Value its = arguments(one->first);
        its[2] = one->second;
        Value& entry = calls[count++];
        entry["methodName"] = "setParam";
        entry["params"] = its;
    }
    Value all;
    all[0] = calls;
    const Value results = call("system.multicall", all);
    if (results.getType() != Value::TypeArray || results.size() != count) notUnderstood();
    for (int i = 0; i != count; ++i) {
        const std::string& name = (first + i)->first;
        // In an array of its own, or a struct that says what is wrong.
        if (results[i].getType() != Value::TypeArray || results[i].size() != 1)
            throw Failure("the ROS master does not set parameter '" + name + "'");
        const Answer answer = answerIn(results[i][0]);
        if (answer.code != 1)
            throw Failure("the ROS master does not set parameter '" + name + "': " + answer.text);
    }
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
    constexpr std::ptrdiff_t kMost = 1000;
    for (auto first = parts.cbegin(); first != parts.cend();) {
        const auto last = parts.cend() - first > kMost ? first + kMost : parts.cend();
        setSome(first, last);
        first = last;
    }
}

void check() { (void)call("getPid", arguments("")); }

}  // namespace rtt_rosparam::master
