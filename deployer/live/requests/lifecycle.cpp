// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verb `lifecycle`.
#include "failure.hpp"
#include "fields.hpp"
#include "interface_json.hpp"
#include "verbs.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/Logger.hpp>

#include <exception>
#include <map>

namespace OCL::live {
namespace {

typedef bool (*Change)(RTT::TaskContext&);

const std::map<std::string, Change>& changes() {
    static const std::map<std::string, Change> all = {
        {"activate", [](RTT::TaskContext& component) { return component.activate(); }},
        {"cleanup", [](RTT::TaskContext& component) { return component.cleanup(); }},
        {"configure", [](RTT::TaskContext& component) { return component.configure(); }},
        {"recover", [](RTT::TaskContext& component) { return component.recover(); }},
        {"start", [](RTT::TaskContext& component) { return component.start(); }},
        {"stop", [](RTT::TaskContext& component) { return component.stop(); }},
    };
    return all;
}

Change changeOf(const std::string& name) {
    const auto found = changes().find(name);
    if (found != changes().end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [each, change] : changes()) known.push_back(each);
    throw Failure(kMalformed, "field 'do' is '" + name + "', expected " + oroforge::diag::oneOf(known));
}

}  // namespace

// The hooks are executed by this thread, as by that of any caller of these functions.
nlohmann::json lifecycle(const Asked& asked) {
    const std::string path = textField(asked.request, "component"), what = textField(asked.request, "do");
    const Change change = changeOf(what);
    Visits visits;
    const Found at = findComponent(asked.root, visits, path);
    const std::string name = at.path.empty() ? at.componentName() : at.path;
    bool done = false;
    try {
        done = change(*at.component);
    } catch (const std::exception& thrown) {
        throw Failure(kFailed, what + "() of component '" + name + "' threw: " + thrown.what());
    }
    const char* const state = stateOf(*at.component);
    RTT::log(RTT::Info) << asked.caller.name << (done ? " " : " has no success with ") << what << "() of component '"
                        << name << "', which is " << state << RTT::endlog();
    return {{"done", done}, {"state", state}};
}

}  // namespace OCL::live
