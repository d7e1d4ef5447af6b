// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A plugin whose start is what the test says.
#include <rtt/plugin/Plugin.hpp>

#include <functional>

namespace {
std::function<bool()> start;
}

extern "C" {
RTT_EXPORT void loadingTestSetStart(const std::function<bool()>& function);
RTT_EXPORT void loadingTestSetStart(const std::function<bool()>& function) { start = function; }
}

bool loadRTTPlugin(RTT::TaskContext* component) { return !component && (!start || start()); }

std::string getRTTPluginName() { return "crossing" + std::to_string(PLUGIN_KIND); }
