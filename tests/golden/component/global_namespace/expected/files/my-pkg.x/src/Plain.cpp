#include "Plain.hpp"

Plain::Plain(const std::string& name) : PlainBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Plain::~Plain() { this->stopForGood(); }

void Plain::go() {
}

int Plain::pick(const std::string& /*first*/, double /*second*/) {
    return {};
}

bool Plain::configureHook() {
    // Check properties, open devices, size buffers. False keeps the component unconfigured.
    return true;
}

bool Plain::startHook() {
    // Prepare for updateHook(). False keeps the component stopped.
    return true;
}

void Plain::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

void Plain::stopHook() {
    // Leave outputs in a safe state.
}

void Plain::cleanupHook() {
    // Undo configureHook().
}
