// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "call_effects.hpp"

#include "lookup.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/internal/calls/standard_operations.hpp>

#include <algorithm>
#include <initializer_list>
#include <map>

namespace OCL::deploy {

namespace {

bool isOneOf(const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

const std::map<std::string, CallEffect>& effects() {
    constexpr NamedArgument::Kind Port = NamedArgument::Port, Path = NamedArgument::Path;
    static const std::map<std::string, CallEffect> all = {
        {"import", {Effect::Import, {}}},
        {"path", {Effect::Path, {}}},
        {"loadLibrary", {Effect::Library, {}}},
        {"loadComponent", {Effect::Component, {}}},
        {"chain", {Effect::Component, {}}},
        {"addPeer", {Effect::Peers, {{0}, {1}}}},
        {"aliasPeer", {Effect::Peers, {{0}, {1}}}},
        {"connectPeers", {Effect::Peers, {{0}, {1}}}},
        {"loadService", {Effect::Service, {{0}}}},
        {"require", {Effect::Require, {}}},
        {"configureComponent", {Effect::Change, {{0}}}},
        {"startComponent", {Effect::Change, {{0}}}},
        {"stopComponent", {Effect::Change, {{0}}}},
        {"configureComponents", {Effect::ChangeAll, {}}},
        {"startComponents", {Effect::ChangeAll, {}}},
        {"stopComponents", {Effect::ChangeAll, {}}},
        {"cleanupComponents", {Effect::ChangeAll, {}}},
        {"unloadComponent", {Effect::Unload, {{0}}}},
        {"kickOutComponent", {Effect::Unload, {{0}}}},
        {"removePeer", {Effect::Unload, {}}},
        {"unloadComponents", {Effect::UnloadAll, {}}},
        {"kickOutAll", {Effect::UnloadAll, {}}},
        {"kickOut", {Effect::UnloadAll, {}}},
        {"loadComponents", {Effect::Description, {}}},
        {"loadConfiguration", {Effect::Description, {}}},
        {"kickStart", {Effect::Description, {}}},
        {"runScript", {Effect::Script, {}}},
        {"connect", {Effect::Wiring, {{0, Port}, {1, Port}}}},
        {"connectPorts", {Effect::Wiring, {{0}, {1}}}},
        {"connectTwoPorts", {Effect::Wiring, {{0}, {2}}}},
        {"stream", {Effect::Wiring, {{0, Port}}}},
        {"createStream", {Effect::Wiring, {{0}}}},
        {"connectServices", {Effect::Wiring, {{0}, {1}}}},
        {"connectOperations", {Effect::Wiring, {{0, Path}, {1, Path}}}},
        {"setActivity", {Effect::None, {{0}}}},
        {"setActivityOnCPU", {Effect::None, {{0}}}},
        {"setPeriodicActivity", {Effect::None, {{0}}}},
        {"setFileDescriptorActivity", {Effect::None, {{0}}}},
        {"setSequentialActivity", {Effect::None, {{0}}}},
        {"setSlaveActivity", {Effect::None, {{0}}}},
        {"setMasterSlaveActivity", {Effect::None, {{0}, {1}}}},
        {"setWaitPeriodPolicy", {Effect::None, {{0}}}},
        {"displayComponentTypes", {Effect::None, {}}},
        {"getComponentTypes", {Effect::None, {}}},
        {"clearConfiguration", {Effect::None, {}}},
        {"waitForInterrupt", {Effect::None, {}}},
        {"waitForSignal", {Effect::None, {}}},
    };
    return all;
}

bool isQueryOfComponent(const std::string& operation) {
    const RTT::internal::StandardOperation* const standard = RTT::internal::standardOperation(operation);
    return standard && standard->isQuery;
}

}  // namespace

const CallEffect& effectOf(const std::string& operation) {
    static const CallEffect none{Effect::None, {}}, anything{Effect::Anything, {}};
    const auto found = effects().find(operation);
    if (found != effects().end()) return found->second;
    return isQueryOfComponent(operation) ? none : anything;
}

bool isHarmless(const std::vector<std::string>& path) {
    return path.size() == 2 &&
           (path.front() == "print" ||
            (path.front() == "os" &&
             isOneOf(path.back(), {"getenv", "isenv", "argc", "argv", "sleep", "millisleep", "usleep", "nanosleep"})));
}

bool isQuery(RTT::TaskContext& component, const std::vector<std::string>& path) {
    if (path.size() == 1) return isQueryOfComponent(path.front());
    if (path.empty() || !isOneOf(path.back(), {"last", "read", "write", "clear", "connected"})) return false;
    std::string port;
    for (std::size_t i = 0; i + 1 != path.size(); ++i) port += (i == 0 ? "" : ".") + path[i];
    return findPort(component, port) != nullptr;
}

}  // namespace OCL::deploy
