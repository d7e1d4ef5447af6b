// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The core's way to services of plugins, without a dependency on the plugin loader.
#ifndef ORO_INTERNAL_SERVICE_LOADER_HPP
#define ORO_INTERNAL_SERVICE_LOADER_HPP

#include <rtt/rtt-config.h>

#include <string>

namespace RTT {
class TaskContext;
namespace internal {

/** Loads a service into a component, or into the GlobalService for null; false if there is no such plugin. */
typedef bool (*ServiceLoaderHook)(const std::string& service, TaskContext* component);

RTT_API void setServiceLoader(ServiceLoaderHook hook);
/** False, with an error logged, also if no loader has been set. */
RTT_API bool loadServicePlugin(const std::string& service, TaskContext* component);

}  // namespace internal
}  // namespace RTT

#endif
