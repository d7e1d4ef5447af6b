#include "Controller.hpp"

namespace tank {

Controller::Controller(const std::string& name) : ControllerBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Controller::~Controller() { this->stopForGood(); }

bool Controller::reset(double /*level*/) {
    return true;
}

bool Controller::configureHook() {
    // Check properties, open devices, size buffers. False keeps the component unconfigured.
    return true;
}

bool Controller::startHook() {
    // Prepare for updateHook(). False keeps the component stopped.
    return true;
}

void Controller::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

void Controller::stopHook() {
    // Leave outputs in a safe state.
}

}  // namespace tank
