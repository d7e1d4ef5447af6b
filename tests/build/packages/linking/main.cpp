#include <rtt/RTT.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/main.h>

int ORO_main(int, char**) {
    const RTT::FactoryMap& types = RTT::ComponentLoader::Instance()->getFactories();
    std::cout << types.count("linked::One") << types.count("linked::Two") << types.count("linked::Shared") << std::endl;
    return 0;
}
