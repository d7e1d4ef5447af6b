// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "reconfigure_fixture.hpp"

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/service.h>
#include <ros/topic.h>
#include <rtt/plugin/PluginLoader.hpp>

#include <sstream>
#include <stdexcept>

namespace reconfigure_test {

void load() {
    static bool isDone = false;
    if (isDone) return;
    isDone = true;
    RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
    RTT::plugin::PluginLoader::Instance()->loadLibrary(SCRIPTING_FILE);
    RTT::plugin::PluginLoader::Instance()->loadLibrary(RECONFIGURE_SERVICE_FILE);
}

namespace {

template <class List, class T>
void push(List& list, const std::string& name, const T& value) {
    list.emplace_back();
    list.back().name = name;
    list.back().value = value;
}

template <class List>
bool find(const List& list, const std::string& name, std::string& text) {
    for (const auto& one : list) {
        if (one.name != name) continue;
        std::ostringstream out;
        out.precision(17);
        out << +one.value;
        text = out.str();
        return true;
    }
    return false;
}

}  // namespace

Config a(const std::string& name, bool value) {
    Config config;
    push(config.bools, name, value);
    return config;
}

Config a(const std::string& name, int value) {
    Config config;
    push(config.ints, name, value);
    return config;
}

Config a(const std::string& name, double value) {
    Config config;
    push(config.doubles, name, value);
    return config;
}

Config a(const std::string& name, const char* value) {
    Config config;
    push(config.strs, name, value);
    return config;
}

Config operator+(Config one, const Config& other) {
    one.bools.insert(one.bools.end(), other.bools.begin(), other.bools.end());
    one.ints.insert(one.ints.end(), other.ints.begin(), other.ints.end());
    one.doubles.insert(one.doubles.end(), other.doubles.begin(), other.doubles.end());
    one.strs.insert(one.strs.end(), other.strs.begin(), other.strs.end());
    return one;
}

bool set(const std::string& ns, const Config& request, Config* response) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config = request;
    const bool isSet = ros::service::call(ns + "/set_parameters", call);
    if (response) *response = call.response.config;
    return isSet;
}

Config updateOf(const std::string& ns) {
    const auto got = ros::topic::waitForMessage<Config>(ns + "/parameter_updates", ros::Duration(10));
    if (!got) throw std::runtime_error("no update");
    return *got;
}

ConfigDescription descriptionOf(const std::string& ns) {
    const auto got = ros::topic::waitForMessage<ConfigDescription>(ns + "/parameter_descriptions", ros::Duration(10));
    if (!got) throw std::runtime_error("no description");
    return *got;
}

std::string in(const Config& config, const std::string& name) {
    std::string text;
    for (const auto& one : config.strs)
        if (one.name == name) return one.value;
    return find(config.bools, name, text) || find(config.ints, name, text) || find(config.doubles, name, text) ? text
                                                                                                               : "-";
}

ServerBase& serverOf(RTT::TaskContext& component) {
    if (!component.loadService("reconfigure")) throw std::runtime_error("no service");
    return dynamic_cast<ServerBase&>(*component.provides("reconfigure"));
}

}  // namespace reconfigure_test
