// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * The C symbols of a plugin library: a service, typekit, transport or anything else that is loaded into the process or
 * a component. A hand-written plugin includes this header and defines the first two. The macros of ServicePlugin.hpp,
 * TypekitPlugin.hpp and TransportPlugin.hpp define all of them.
 */
#ifndef ORO_PLUGIN_HPP
#define ORO_PLUGIN_HPP

#include <rtt/rtt-config.h>
#include "c_linkage.hpp"
#include "version_guard.hpp"

#include <string>

namespace RTT {
class TaskContext;
}

ORO_PLUGIN_C_LINKAGE_BEGIN_

/**
 * Called once with null when the library is loaded into the process, and with the component for each `loadService`.
 * Returns false to refuse. Not real-time; called in the thread that loads. May throw: the loader logs the exception.
 */
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component);

/** The name of the plugin. A second plugin of the same name is not loaded into a process. */
RTT_EXPORT std::string getRTTPluginName();

/** The target for which the plugin was built, e.g. `OROCOS_TARGET_NAME`; optional, but checked if defined. */
RTT_EXPORT std::string getRTTTargetName();

ORO_PLUGIN_C_LINKAGE_END_

#endif
