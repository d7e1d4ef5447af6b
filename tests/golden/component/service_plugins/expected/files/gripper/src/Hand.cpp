#include "Hand.hpp"

namespace gripper {

Hand::Hand(const std::string& name) : HandBase(name) {}

// Stopping here keeps hooks from running in an object that is half destroyed.
Hand::~Hand() { this->stop(); }

bool Hand::motion_open() {
    return true;
}

bool Hand::motion_limits_isInside(double /*opening*/) {
    return true;
}

void Hand::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

}  // namespace gripper
