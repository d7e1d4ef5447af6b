// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_LOAD_PLUGIN_HPP
#define ORO_CORBA_DETAIL_LOAD_PLUGIN_HPP

#include <rtt/OperationInterface.hpp>

namespace RTT {
namespace corba {
namespace detail {

/**
 * What every service has for other processes, beside its own operations: bool loadPlugin(string plugin_path), which
 * loads that library into this process. It throws if other computers can connect to this process, because a library
 * can do whatever the user can. Exists until the process ends.
 */
const OperationInterface& operationsOfEveryService();

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
