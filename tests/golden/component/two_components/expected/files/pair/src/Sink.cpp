#include "Sink.hpp"

namespace pair {

Sink::Sink(const std::string& name) : SinkBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Sink::~Sink() { this->stopForGood(); }

double Sink::sum() {
    return {};
}

bool Sink::configureHook() {
    // Check properties, open devices, size buffers. False keeps the component unconfigured.
    return true;
}

bool Sink::startHook() {
    // Prepare for updateHook(). False keeps the component stopped.
    return true;
}

void Sink::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

void Sink::stopHook() {
    // Leave outputs in a safe state.
}

void Sink::cleanupHook() {
    // Undo configureHook().
}

}  // namespace pair
