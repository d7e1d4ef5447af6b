#include "Client.hpp"

namespace services {

Client::Client(const std::string& name) : ClientBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Client::~Client() { this->stopForGood(); }

bool Client::configureHook() {
    // Check properties, open devices, size buffers. False keeps the component unconfigured.
    return true;
}

bool Client::startHook() {
    // Prepare for updateHook(). False keeps the component stopped.
    return true;
}

void Client::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

void Client::stopHook() {
    // Leave outputs in a safe state.
}

void Client::cleanupHook() {
    // Undo configureHook().
}

}  // namespace services
