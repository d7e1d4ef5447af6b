// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Hand.hpp"

#include <algorithm>

namespace gripper {

Hand::Hand(const std::string& name) : HandBase(name) {}

Hand::~Hand() { this->stopForGood(); }

bool Hand::motion_moveTo(double wanted) {
    if (wanted < 0 || wanted > widest_) return false;
    target = wanted;
    return true;
}

void Hand::updateHook() {
    const double step = motion_speed_ * this->getPeriod();
    width += std::clamp(target - width, -step, step);
    opening_.write(width);
}

}  // namespace gripper
