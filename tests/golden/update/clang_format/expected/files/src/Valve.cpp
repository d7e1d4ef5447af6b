#include "Valve.hpp"

namespace tank
{

Valve::Valve(const std::string& name) : ValveBase(name)
{
}

// From here on no other thread executes hooks or operations
// of an object that is half destroyed.
Valve::~Valve()
{
    this->stopForGood();
}

void Valve::open()
{
}

bool Valve::configureHook()
{
    // Check properties, open devices, size buffers. False
    // keeps the component unconfigured.
    return true;
}

bool Valve::startHook()
{
    // Prepare for updateHook(). False keeps the component
    // stopped.
    return true;
}

void Valve::updateHook()
{
    // One step: read inputs, compute, write outputs. Runs
    // in the component's thread; keep it free of blocking
    // calls.
}

void Valve::stopHook()
{
    // Leave outputs in a safe state.
}

void Valve::cleanupHook()
{
    // Undo configureHook().
}

} // namespace tank
