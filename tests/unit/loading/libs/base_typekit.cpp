// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A plugin that others are linked with.
#include <rtt/plugin/Plugin.hpp>

extern "C" {
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext*);
RTT_EXPORT std::string getRTTPluginName();
RTT_EXPORT std::string getRTTTargetName();
}

bool loadRTTPlugin(RTT::TaskContext*) { return true; }
std::string getRTTPluginName() { return "loading_base"; }
std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
