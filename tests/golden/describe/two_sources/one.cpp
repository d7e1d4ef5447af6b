#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

static double helper() { return 1; }  // of the same name in the other source

struct One : RTT::TaskContext {
    explicit One(const std::string& name) : TaskContext(name), value(helper()) {
        addOperation("value", [this] { return value; });
    }
    double value;
};
ORO_LIST_COMPONENT_TYPE(One)
