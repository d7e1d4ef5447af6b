// A plugin written by hand, as those that bridge to other middleware are.
#include <rtt/RTT.hpp>
#include <rtt/plugin/Plugin.hpp>

static int twice(int value) { return 2 * value; }

extern "C" {
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component == 0) return true;
    component->provides("byhand")->addOperation("twice", &twice).doc("Twice the value").arg("value", "a number");
    return true;
}
RTT_EXPORT std::string getRTTPluginName() { return "byhand"; }
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
}
