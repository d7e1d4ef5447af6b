#include "Slave.hpp"

namespace acts {

Slave::Slave(const std::string& name) : SlaveBase(name) {}

// Stopping here keeps hooks from running in an object that is half destroyed.
Slave::~Slave() { this->stop(); }

void Slave::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

}  // namespace acts
