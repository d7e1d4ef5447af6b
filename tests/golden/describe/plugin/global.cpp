#include <rtt/RTT.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

class Watch : public RTT::Service {
public:
    explicit Watch(RTT::TaskContext* owner) : RTT::Service("watch", owner) { addConstant("rate", 10); }
};

ORO_GLOBAL_SERVICE_NAMED_PLUGIN(Watch, "watch")
