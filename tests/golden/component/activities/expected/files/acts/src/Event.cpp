#include "Event.hpp"

namespace acts {

Event::Event(const std::string& name) : EventBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Event::~Event() { this->stopForGood(); }

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
