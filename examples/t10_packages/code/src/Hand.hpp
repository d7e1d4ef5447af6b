// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef GRIPPER_HAND_HPP
#define GRIPPER_HAND_HPP

#include <gripper/HandBase.hpp>

namespace gripper {

/// Moves its fingers to where it is told.
class Hand : public HandBase {
public:
    explicit Hand(const std::string& name);
    ~Hand() override;

    /// False if it cannot be that wide.
    bool motion_moveTo(double opening) override;

protected:
    void updateHook() override;

private:
    double width = 0;
    double target = 0;
};

}  // namespace gripper

#endif
