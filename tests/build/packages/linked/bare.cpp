// Never starts the runtime.
#include <rtt/RTT.hpp>
#include <rtt/deployment/ComponentLoader.hpp>

int main() {
    RTT::TaskContext onStack("stack");
    RTT::TaskContext* loaded = RTT::ComponentLoader::Instance()->loadComponent("two", "linked::Two");
    if (!loaded || !onStack.addPeer(loaded)) return 1;
    std::cout << onStack.getPeer("two")->getName() << std::endl;
    onStack.removePeer("two");
    return RTT::ComponentLoader::Instance()->unloadComponent(loaded) ? 0 : 2;
}
