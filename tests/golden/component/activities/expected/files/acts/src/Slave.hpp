#ifndef ACTS_SLAVE_HPP
#define ACTS_SLAVE_HPP

#include <acts/SlaveBase.hpp>

namespace acts {

/// Ports, properties and attributes are members of the base class: SlaveBase, generated from acts.xml.
class Slave : public SlaveBase {
public:
    explicit Slave(const std::string& name);
    ~Slave() override;

protected:
    void updateHook() override;
};

}  // namespace acts

#endif
