// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef GRIPPER_RECORDER_HPP
#define GRIPPER_RECORDER_HPP

#include <gripper/RecorderBase.hpp>

namespace gripper {

/// Keeps what its owner tells it.
class Recorder : public RecorderBase {
public:
    explicit Recorder(RTT::TaskContext* owner);

    void keep(double value) override;

    double mean() override;

private:
    double sum = 0;
    unsigned count = 0;
};

}  // namespace gripper

#endif
