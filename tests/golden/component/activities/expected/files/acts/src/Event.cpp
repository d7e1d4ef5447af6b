#include "Event.hpp"

namespace acts {

Event::Event(const std::string& name) : EventBase(name) {}

// Stopping here keeps hooks from running in an object that is half destroyed.
Event::~Event() { this->stop(); }

bool Event::startHook() {
    // Prepare for updateHook(). False keeps the component stopped.
    return true;
}

void Event::stopHook() {
    // Leave outputs in a safe state.
}

void Event::cleanupHook() {
    // Undo configureHook().
}

}  // namespace acts
