#include <rtt/RTT.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

struct Greeter : RTT::Service {
    explicit Greeter(RTT::TaskContext* owner) : RTT::Service("linked.global", owner) {
        addOperation("greet", &Greeter::greet, this);
    }
    std::string greet() { return "hello"; }
};
ORO_GLOBAL_SERVICE_NAMED_PLUGIN(Greeter, "linked.global")
