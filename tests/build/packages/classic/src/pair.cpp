#include "support.hpp"
#include <classic/classic-types.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/Port.hpp>
#include <rtt/Component.hpp>
namespace classic {
struct First : RTT::TaskContext {
    First(std::string const& name) : RTT::TaskContext(name) { addPort("track", port); }
    bool startHook() {
        Track t;
        t.name = "spiral";
        t.points.resize(classicAnswer());
        return port.write(t) == RTT::WriteSuccess;
    }
    RTT::OutputPort<Track> port;
};
struct Second : RTT::TaskContext {
    Second(std::string const& name) : RTT::TaskContext(name) { addEventPort("track", port); }
    void updateHook() {
        Track t;
        if (port.read(t) == RTT::NewData) std::cout << "second: " << t.name << " " << t.points.size() << std::endl;
    }
    RTT::InputPort<Track> port;
};
}
ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(classic::First)
ORO_LIST_COMPONENT_TYPE(classic::Second)
