#include "support.hpp"
#include <rtt/os/main.h>
#include <rtt/RTT.hpp>
int ORO_main(int, char**) {
    RTT::TaskContext a("a"), b("b");
    RTT::OutputPort<int> out("p");
    RTT::InputPort<int> in("p");
    a.ports()->addPort(out);
    b.ports()->addPort(in);
    if (!a.connectPorts(&b) || out.write(classicAnswer()) != RTT::WriteSuccess) return 1;
    int value = 0;
    if (in.read(value) != RTT::NewData || value != 42) return 2;
    std::cout << "main: " << value << std::endl;
    return 0;
}
