#include "All.hpp"

namespace values {

All::All(const std::string& name) : AllBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
All::~All() { this->stopForGood(); }

bool All::configureHook() {
    // Check properties, open devices, size buffers. False keeps the component unconfigured.
    return true;
}

bool All::startHook() {
    // Prepare for updateHook(). False keeps the component stopped.
    return true;
}

void All::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

void All::stopHook() {
    // Leave outputs in a safe state.
}

void All::cleanupHook() {
    // Undo configureHook().
}

}  // namespace values
