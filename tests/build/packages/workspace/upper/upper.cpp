#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>
int lowerNumber();
int upperNumber() { return 2 * lowerNumber(); }
class Upper : public RTT::TaskContext {
public:
    explicit Upper(const std::string& name) : TaskContext(name) {}
};
ORO_CREATE_COMPONENT(Upper)
