#include "Source.hpp"

namespace pair {

Source::Source(const std::string& name) : SourceBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Source::~Source() { this->stopForGood(); }

bool Source::configureHook() {
    // Check properties, open devices, size buffers. False keeps the component unconfigured.
    return true;
}

bool Source::startHook() {
    // Prepare for updateHook(). False keeps the component stopped.
    return true;
}

void Source::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

void Source::stopHook() {
    // Leave outputs in a safe state.
}

void Source::cleanupHook() {
    // Undo configureHook().
}

}  // namespace pair
