#include <cstdlib>
#include <rtt/RTT.hpp>
#include <rtt/plugin/Plugin.hpp>

bool loadRTTPlugin(RTT::TaskContext*) { return true; }

std::string getRTTPluginName() { return std::getenv(std::string(1, 'N').c_str()); }

std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
