// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Hand-written plugins that must not be loaded; PLUGIN_KIND tells which one this is.
#include <rtt/plugin/Plugin.hpp>

#include <stdexcept>

bool loadRTTPlugin(RTT::TaskContext*) {
#if PLUGIN_KIND == 1
    return false;
#elif PLUGIN_KIND == 2
    throw std::runtime_error("no licence for this robot");
#else
    return true;
#endif
}

std::string getRTTPluginName() {
#if PLUGIN_KIND == 4
    throw std::runtime_error("no name on the box");
#endif
    return "odd" + std::to_string(PLUGIN_KIND);
}

#if PLUGIN_KIND == 3
std::string getRTTTargetName() { return "xenomai"; }
#endif
