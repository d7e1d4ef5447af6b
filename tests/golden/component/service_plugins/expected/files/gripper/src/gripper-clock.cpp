#include <string>

#include <rtt/RTT.hpp>
#include <rtt/plugin/Plugin.hpp>

/// Sets the clock when it is loaded.
///
/// Called once for the process with a null pointer, and once for each component that loads the plugin.
/// False refuses: the plugin is unloaded.
bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component == nullptr) {
        RTT::log(RTT::Info) << "plugin gripper-clock loaded into the process" << RTT::endlog();
    } else {
        RTT::log(RTT::Info) << "plugin gripper-clock loaded into " << component->getName() << RTT::endlog();
    }
    return true;
}

/// The name by which it is loaded; one per process.
std::string getRTTPluginName() { return "gripper-clock"; }

std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
