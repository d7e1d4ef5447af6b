// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "parameter_binding.hpp"

#include "detail/fill_value.hpp"
#include "detail/guarded.hpp"
#include "detail/master.hpp"
#include "detail/names.hpp"
#include "detail/read_value.hpp"

#include <ros/param.h>
#include <rtt/Logger.hpp>

namespace rtt_rosparam {

using namespace RTT;

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
        // roscpp's own call waits for ever if the master hangs.
        if (!isCached_) master::check();
        XmlRpc::XmlRpcValue found;
        if (!ros::param::getCached(full, found)) throw Failure("parameter '" + full + "' is not set");
        isCached_ = true;
        Filler(full).fill(type_->name(), found, value);
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

}  // namespace rtt_rosparam
