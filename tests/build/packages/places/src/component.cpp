#include <places/typekit/Types.hpp>

#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>
class Places : public RTT::TaskContext {
public:
    explicit Places(const std::string& name) : TaskContext(name), in("in"), out("out") {
        addPort(in);
        addPort(out);
    }
    RTT::InputPort<places::Value> in;
    RTT::OutputPort<places::States> out;
};
ORO_CREATE_COMPONENT(Places)
