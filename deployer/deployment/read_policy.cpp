// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "read_value.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <climits>

namespace OCL::deploy {
namespace {

using RTT::ConnPolicy;

/** An integer member of the policy and its range. */
struct NumberMember {
    const char* name;
    long long least, most;
    void (*store)(ConnPolicy&, int);
    const char* meaning = "";  // what the numbers mean
};

const NumberMember kNumbers[] = {
    {"type", ConnPolicy::UNBUFFERED, ConnPolicy::CIRCULAR_BUFFER, [](ConnPolicy& p, int v) { p.type = v; },
     "0 for data, 1 for a buffer, 2 for a circular buffer"},
    {"size", 0, INT_MAX, [](ConnPolicy& p, int v) { p.size = v; }},
    {"lock_policy", ConnPolicy::UNSYNC, ConnPolicy::LOCK_FREE, [](ConnPolicy& p, int v) { p.lock_policy = v; },
     "0 for unsynchronised, 1 for locked, 2 for lock free"},
    {"buffer_policy", RTT::UnspecifiedBufferPolicy, RTT::Shared, [](ConnPolicy& p, int v) { p.buffer_policy = v; },
     "1 for each connection, 2 for each input port, 3 for each output port, 4 for shared by all"},
    {"max_threads", 0, INT_MAX, [](ConnPolicy& p, int v) { p.max_threads = v; }},
    {"transport", 0, INT_MAX, [](ConnPolicy& p, int v) { p.transport = v; }},
    {"data_size", 0, INT_MAX, [](ConnPolicy& p, int v) { p.data_size = v; }},
};

struct FlagMember {
    const char* name;
    void (*store)(ConnPolicy&, bool);
};

const FlagMember kFlags[] = {
    {"init", [](ConnPolicy& p, bool v) { p.init = v; }},
    {"pull", [](ConnPolicy& p, bool v) { p.pull = v; }},
    {"mandatory", [](ConnPolicy& p, bool v) { p.mandatory = v; }},
};

std::vector<std::string> memberNames() {
    std::vector<std::string> names;
    for (const NumberMember& member : kNumbers) names.push_back(member.name);
    for (const FlagMember& member : kFlags) names.push_back(member.name);
    names.push_back("name_id");
    return names;
}

bool isMember(const std::string& name) {
    const std::vector<std::string> names = memberNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

void readMember(const xml::Element& element, ConnPolicy& policy, diag::Sink& sink) {
    const Text name = nameOf(element);
    for (const NumberMember& member : kNumbers)
        if (name.value == member.name) {
            if (const auto number = readInteger(element, member.least, member.most, sink, member.meaning))
                member.store(policy, static_cast<int>(*number));
            return;
        }
    for (const FlagMember& member : kFlags)
        if (name.value == member.name) {
            if (const auto flag = readBoolean(element, sink)) member.store(policy, *flag);
            return;
        }
    if (name.value == "name_id") {
        if (const auto text = readString(element, sink)) policy.name_id = text->value;
        return;
    }
    sink.error(
        name.where, "DEP010",
        "unknown member '" + name.value + "' in connection policy" + diag::didYouMean(name.value, memberNames()));
}

}  // namespace

bool isPolicy(const xml::Element& element) {
    if (element.name != "struct") return false;
    if (typeOf(element).value == "ConnPolicy") return true;
    // Old files have another type, so the members decide.
    bool any = false;
    for (const xml::Element& child : element.children) {
        if (child.name == "description") continue;
        if (!isMember(nameOf(child).value)) return false;
        any = true;
    }
    return any;
}

PolicyPlan readPolicy(const xml::Element& element, const RTT::ConnPolicy& policy, diag::Sink& sink) {
    PolicyPlan plan;
    plan.policy = policy;
    plan.name = nameOf(element);
    const std::size_t errorsBefore = sink.errorCount();
    checkTwice(element, {}, sink);
    bool any = false, namesSize = false;
    for (const xml::Element& child : element.children)
        if (child.name != "description") {
            readMember(child, plan.policy, sink);
            any = true;
            namesSize |= nameOf(child).value == "size";
        }
    if (!any)
        sink.warning(element.where, "DEP011",
                     "connection policy '" + plan.name.value + "' has no members; the default policy is used");
    const bool buffered = plan.policy.type == ConnPolicy::BUFFER || plan.policy.type == ConnPolicy::CIRCULAR_BUFFER;
    const bool isStream = plan.policy.transport != 0;  // transports choose their own size
    // A malformed size has been reported already.
    const bool reported = namesSize && sink.errorCount() != errorsBefore;
    if (buffered && plan.policy.size <= 0 && !isStream && !reported)
        sink.error(element.where, "DEP011",
                   "buffered connection '" + plan.name.value + "' has no 'size', expected at least 1");
    return plan;
}

}  // namespace OCL::deploy
