#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

static double helper() { return 2; }

struct Two : RTT::TaskContext {
    explicit Two(const std::string& name) : TaskContext(name), value(helper()) { addProperty("value", value); }
    double value;
};
ORO_LIST_COMPONENT_TYPE(Two)
