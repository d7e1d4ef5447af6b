#include "FreeSlave.hpp"

namespace acts {

FreeSlave::FreeSlave(const std::string& name) : FreeSlaveBase(name) {}

// Stopping here keeps hooks from running in an object that is half destroyed.
FreeSlave::~FreeSlave() { this->stop(); }

}  // namespace acts
