// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_MASTER_HPP
#define RTT_ROSPARAM_DETAIL_MASTER_HPP

#include "failure.hpp"

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <utility>
#include <vector>

namespace rtt_rosparam {

/** The parameter server. All functions are thread-safe, block until it answers, at most kPatience seconds for each call
    of it, and throw Failure: no ROS node, no master, no answer, or it refuses. */
namespace master {

constexpr double kPatience = 5;

typedef std::vector<std::pair<std::string, XmlRpc::XmlRpcValue>> Parameters;

/** False if the parameter is not set. */
bool get(const std::string& name, XmlRpc::XmlRpcValue& value);
/** Sets all of these, in as few calls as possible, also in roscpp's cache. Parameters that are not named stay, also
    within a struct. One that is refused does not hinder others; the text of the failure names each. */
void set(const Parameters& parameters);
/** Does the master answer? */
void check();

}  // namespace master

}  // namespace rtt_rosparam

#endif
