#ifndef GRIPPER_HAND_HPP
#define GRIPPER_HAND_HPP

#include <gripper/HandBase.hpp>

namespace gripper {

/// Opens and closes.
/// Ports, properties and attributes are members of the base class: HandBase, generated from gripper.xml.
class Hand : public HandBase {
public:
    explicit Hand(const std::string& name);
    ~Hand() override;

    /// Opens as wide as it can.
    bool motion_open() override;

    bool motion_limits_isInside(double opening) override;

protected:
    void updateHook() override;
};

}  // namespace gripper

#endif
