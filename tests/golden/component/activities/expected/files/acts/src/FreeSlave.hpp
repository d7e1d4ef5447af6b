#ifndef ACTS_FREESLAVE_HPP
#define ACTS_FREESLAVE_HPP

#include <acts/FreeSlaveBase.hpp>

namespace acts {

/// Ports, properties and attributes are members of the base class: FreeSlaveBase, generated from acts.xml.
class FreeSlave : public FreeSlaveBase {
public:
    explicit FreeSlave(const std::string& name);
    ~FreeSlave() override;
};

}  // namespace acts

#endif
