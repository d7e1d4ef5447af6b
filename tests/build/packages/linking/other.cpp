#include <rtt/Component.hpp>

struct Other : RTT::TaskContext {
    explicit Other(const std::string& name) : RTT::TaskContext(name) {}
};
ORO_CREATE_COMPONENT(Other)
