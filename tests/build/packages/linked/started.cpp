// Starts and stops the runtime by hand, twice, and once more than needed.
#include <rtt/RTT.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>

int main(int argc, char** argv) {
    for (int round = 0; round < 2; ++round) {
        if (__os_init(argc, argv) != 0) return 1;
        if (!RTT::plugin::PluginLoader::Instance()->loadTypekit("rtt-typekit", "")) return 2;
        if (!RTT::ComponentLoader::Instance()->import("linked", "")) return 3;
        RTT::TaskContext* component = RTT::ComponentLoader::Instance()->loadComponent("started", "linked::Shared");
        if (!component || !component->start()) return 4;
        component->stop();
        if (!RTT::ComponentLoader::Instance()->unloadComponent(component)) return 5;
        __os_exit();
        __os_exit();
    }
    return 0;
}
