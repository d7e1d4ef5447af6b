// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The core's way to plugins, without a dependency on the plugin loader.
#ifndef ORO_INTERNAL_PLUGIN_LOADING_HPP
#define ORO_INTERNAL_PLUGIN_LOADING_HPP

#include <rtt/rtt-config.h>

#include <string>

namespace RTT {
class TaskContext;
namespace internal {

/** Loads a service into a component, or into the GlobalService for null; false if there is no such plugin. */
typedef bool (*ServiceLoaderHook)(const std::string& service, TaskContext* component);
/** Loads the toolchain's own transport for a protocol; false if there is none, or if it is loaded already. */
typedef bool (*TransportLoaderHook)(int protocol);

/** Null sets none. */
RTT_API void setPluginLoader(ServiceLoaderHook services, TransportLoaderHook transports);
/** False, with an error logged, also if no loader has been set. */
RTT_API bool loadServicePlugin(const std::string& service, TaskContext* component);
/** False, also if no loader has been set. */
RTT_API bool loadTransportPlugin(int protocol);

}  // namespace internal
}  // namespace RTT

#endif
