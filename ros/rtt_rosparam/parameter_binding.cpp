// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "parameter_binding.hpp"

#include "detail/fill_value.hpp"
#include "detail/master.hpp"
#include "detail/names.hpp"
#include "detail/read_value.hpp"
#include "detail/xml_value.hpp"

#include <ros/init.h>
#include <ros/param.h>
#include <rtt/Logger.hpp>
#include <rtt_ros/guarded.hpp>

namespace rtt_rosparam {

using namespace RTT;
using rtt_ros::problemIn;
typedef XmlRpc::XmlRpcValue Value;

struct ParameterBinding::State {
    /** False if the parameter is not set. */
    bool fetch(const std::string& full, Value& found);

    Value taken;  // the parameter as which the value is known, invalid if there is none
    Value lent;   // the value when it was last looked at, invalid if it cannot be a parameter
    bool isLent = false;
    bool isCached = false;
    bool isEmpty = false, isEmptySet = false;  // the cache has an empty struct; does the master, too?
    std::string reported;
};

bool ParameterBinding::State::fetch(const std::string& full, Value& found) {
    // Without its own server the node would never learn of changes.
    if (!ros::isStarted()) return master::get(full, found);
    // roscpp's own call waits for ever if the master hangs.
    if (!isCached) master::check();
    const bool isSet = ros::param::getCached(full, found);
    isCached = true;  // also that it is not set
    const bool wasEmpty = isEmpty;
    isEmpty = isSet && found.getType() == Value::TypeStruct && found.size() == 0;
    if (!isEmpty) return isSet;
    // This is also what the master sends when another node has deleted the parameter.
    if (!wasEmpty) {
        isEmpty = false;
        isEmptySet = master::get(full, found);
        isEmpty = true;
    }
    return isEmptySet;
}

ParameterBinding::ParameterBinding(const std::string& name, const std::type_info& type)
    : name_(name), type_(&type), state_(std::make_unique<State>()) {}

ParameterBinding::~ParameterBinding() = default;

void ParameterBinding::report(const std::string& problem) {
    if (!problem.empty() && problem != state_->reported) log(Error) << problem << endlog();
    state_->reported = problem;
}

bool ParameterBinding::read(void* value) {
    const Logger::In in("rosparam");
    bool isNew = false;
    report(problemIn([&] {
        const std::string full = resolved(name_);
        Value found;
        if (!state_->fetch(full, found)) throw Failure("parameter '" + full + "' is not set");
        if (found.valid() && same(found, state_->taken)) return;
        Filler(full).fill(type_->name(), found, value);
        state_->taken = found;
        isNew = true;
        if (state_->isLent) lend(value);
    }));
    return isNew;
}

bool ParameterBinding::write(const void* value) {
    const Logger::In in("rosparam");
    state_->taken.clear();
    const std::string problem = problemIn([&] {
        const std::string full = resolved(name_);
        const Value made = Reader(full).read(type_->name(), value);
        // roscpp forgets a struct when a member changes, and asks the master again.
        if (made.getType() == Value::TypeStruct) state_->isCached = false;
        master::set({{full, made}});
        state_->taken = made;
    });
    if (!problem.empty()) log(Error) << problem << endlog();
    return problem.empty();
}

void ParameterBinding::lend(const void* value) {
    state_->isLent = true;
    state_->lent.clear();
    (void)problemIn([&] { state_->lent = Reader(name_).read(type_->name(), value); });
}

void ParameterBinding::settle(const void* value) {
    if (!state_->isLent) return;
    const Value before = state_->lent;
    lend(value);
    if (!same(before, state_->lent)) (void)write(value);
}

}  // namespace rtt_rosparam
