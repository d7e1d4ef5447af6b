#include <rtt/RTT.hpp>
#include <rtt/plugin/Plugin.hpp>

/// Prints when it is loaded.
bool loadRTTPlugin(RTT::TaskContext* component) { return component == nullptr; }

std::string getRTTPluginName() { return "clock"; }

std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
