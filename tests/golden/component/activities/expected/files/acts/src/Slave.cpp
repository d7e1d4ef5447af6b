#include "Slave.hpp"

namespace acts {

Slave::Slave(const std::string& name) : SlaveBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Slave::~Slave() { this->stopForGood(); }

void Slave::updateHook() {
    // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
}

}  // namespace acts
