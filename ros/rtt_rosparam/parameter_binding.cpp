// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "parameter_binding.hpp"

#include "detail/fill_value.hpp"
#include "detail/guarded.hpp"
#include "detail/master.hpp"
#include "detail/names.hpp"
#include "detail/read_value.hpp"

#include <ros/init.h>
#include <ros/param.h>
#include <rtt/Logger.hpp>

namespace rtt_rosparam {

using namespace RTT;

struct ParameterBinding::Lent {
    XmlRpc::XmlRpcValue value;  // invalid if it cannot be a parameter
};

namespace {

bool fetch(const std::string& name, bool isCached, XmlRpc::XmlRpcValue& value) {
    // Without its own server the node would never learn of changes.
    if (!ros::isStarted()) return master::get(name, value);
    // roscpp's own call waits for ever if the master hangs.
    if (!isCached) master::check();
    return ros::param::getCached(name, value);
}

}  // namespace

ParameterBinding::ParameterBinding(const std::string& name, const std::type_info& type) : name_(name), type_(&type) {}

ParameterBinding::~ParameterBinding() = default;

bool ParameterBinding::report(const std::string& problem) {
    if (problem.empty()) {
        reported_.clear();
        return true;
    }
    if (problem != reported_) log(Error) << problem << endlog();
    reported_ = problem;
    return false;
}

bool ParameterBinding::read(void* value) {
    const Logger::In in("rosparam");
    return report(problemIn([&] {
        const std::string full = resolved(name_);
        XmlRpc::XmlRpcValue found;
        if (!fetch(full, isCached_, found)) throw Failure("parameter '" + full + "' is not set");
        isCached_ = ros::isStarted();
        Filler(full).fill(type_->name(), found, value);
        if (lent_) lend(value);
    }));
}

bool ParameterBinding::write(const void* value) {
    const Logger::In in("rosparam");
    const std::string problem = problemIn([&] {
        const std::string full = resolved(name_);
        const XmlRpc::XmlRpcValue made = Reader(full).read(type_->name(), value);
        master::check();
        // This one, unlike ours, changes roscpp's cache at once.
        ros::param::set(full, made);
    });
    if (!problem.empty()) log(Error) << problem << endlog();
    return problem.empty();
}

void ParameterBinding::lend(const void* value) {
    lent_ = std::make_unique<Lent>();
    (void)problemIn([&] { lent_->value = Reader(name_).read(type_->name(), value); });
}

void ParameterBinding::settle(const void* value) {
    if (!lent_) return;
    const XmlRpc::XmlRpcValue before = lent_->value;
    lend(value);
    if (before != lent_->value) (void)write(value);
}

}  // namespace rtt_rosparam
