#include "support.hpp"
#include <rtt/RTT.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
struct Stamp : RTT::Service {
    Stamp(RTT::TaskContext* owner) : RTT::Service("stamp", owner) {
        addOperation("ownerName", &Stamp::ownerName, this);
        addConstant("answer", answer);
    }
    int answer = classicAnswer();
    std::string ownerName() { return getOwner()->getName(); }
};
ORO_SERVICE_NAMED_PLUGIN(Stamp, "stamp")
