// Creates a component of every library it is linked with, without importing anything.
#include <rtt/RTT.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/main.h>

int linkedPart();

int ORO_main(int argc, char* argv[]) {
    if (__os_main_argc() != argc || __os_main_argv()[0] != argv[0]) return 2;
    const RTT::ComponentLoader::shared_ptr loader = RTT::ComponentLoader::Instance();
    int created = linkedPart() - 1;
    for (const char* type :
         {"linked::Shared", "linked::Other", "linked::One", "linked::Two", "linked::Archived", "linked::Plain"}) {
        RTT::TaskContext* component = loader->loadComponent("c", type);
        if (!component) continue;
        ++created;
        if (!loader->unloadComponent(component)) return 3;
    }
    std::cout << "created " << created << std::endl;
    return created == 6 ? 0 : 1;
}
