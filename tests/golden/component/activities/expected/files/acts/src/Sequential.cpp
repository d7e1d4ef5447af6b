#include "Sequential.hpp"

namespace acts {

Sequential::Sequential(const std::string& name) : SequentialBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Sequential::~Sequential() { this->stopForGood(); }

bool Sequential::configureHook() {
    // Check properties, open devices, size buffers. False keeps the component unconfigured.
    return true;
}

void Sequential::errorHook() {
    // Runs instead of updateHook() after error(); call recover() to go back.
}

void Sequential::exceptionHook() {
    // An exception left a hook, or exception() was called. Release what stopHook() and cleanupHook() would not.
}

}  // namespace acts
