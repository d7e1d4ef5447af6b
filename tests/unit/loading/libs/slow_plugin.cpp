// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A plugin that takes its time to start, and loads itself meanwhile; it counts how often it was started.
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/Plugin.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <atomic>
#include <chrono>
#include <thread>

namespace {
std::atomic<int> starts{0};
}

RTT_EXPORT int loadingTestStarts();
RTT_EXPORT int loadingTestStarts() { return starts; }

bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component) return false;
    ++starts;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // gives the other thread a chance to come in between
    return RTT::plugin::PluginLoader::Instance()->loadPlugin("slow", "/nowhere");
}

std::string getRTTPluginName() { return "slow"; }
