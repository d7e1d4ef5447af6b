#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

struct Common : RTT::TaskContext {
    using TaskContext::TaskContext;
};
struct Listed : Common {
    using Common::Common;
    void startHook(int);  // hides the hook, but is none
};
/** Nobody lists it. */
struct Forgotten : RTT::TaskContext {
    explicit Forgotten(const std::string& name) : TaskContext(name) {}
};
ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(Listed)
