#include "Hand.hpp"

namespace gripper {

Hand::Hand(const std::string& name) : HandBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Hand::~Hand() { this->stopForGood(); }

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
