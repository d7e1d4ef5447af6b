#include "FreeSlave.hpp"

namespace acts {

FreeSlave::FreeSlave(const std::string& name) : FreeSlaveBase(name) {}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
FreeSlave::~FreeSlave() { this->stopForGood(); }

}  // namespace acts
