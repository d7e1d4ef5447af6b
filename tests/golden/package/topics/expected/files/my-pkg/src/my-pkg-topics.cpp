#include "my-pkg-topics.hpp"

#include <rtt/Component.hpp>

namespace robots {

My_pkgTopics::My_pkgTopics(const std::string& name) : RTT::TaskContext(name) {
    // Each message wakes the component.
    addEventPort("command", command_).doc("What is to be reached.");
    addPort("state", state_).doc("What has been reached.");
}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
My_pkgTopics::~My_pkgTopics() { this->stopForGood(); }

void My_pkgTopics::updateHook() {
    std_msgs::Float64 value;
    while (command_.read(value) == RTT::NewData) state_.write(value);
}

}  // namespace robots

ORO_CREATE_COMPONENT(robots::My_pkgTopics)
