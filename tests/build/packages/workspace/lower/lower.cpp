#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>
int lowerSupport();
int lowerNumber() { return lowerSupport(); }
class Lower : public RTT::TaskContext {
public:
    explicit Lower(const std::string& name) : TaskContext(name) {}
};
ORO_CREATE_COMPONENT(Lower)
