#include "valve.hpp"

#include <rtt/Activity.hpp>
#include <rtt/Component.hpp>

namespace valve {

Valve::Valve(const std::string& name) : RTT::TaskContext(name, PreOperational) {
    addEventPort(wanted_).doc("where to");
    ports()->addPort("closed", closed_);
    addProperty("speed", speed_).doc("of the spindle [1/s]");
    addProperty("label", label_);
    addConstant("limit", 2.0);
    addOperation("open", &Valve::open, this, RTT::OwnThread).doc("Opens.").arg("by", "how far");
    setActivity(new RTT::Activity(ORO_SCHED_RT, 20, 0.01));
}

bool Valve::configureHook() { return true; }
void Valve::open(double) {}

}  // namespace valve

ORO_CREATE_COMPONENT(valve::Valve)
