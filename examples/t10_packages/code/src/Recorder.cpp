// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Recorder.hpp"

namespace gripper {

Recorder::Recorder(RTT::TaskContext* owner) : RecorderBase(owner) {}

void Recorder::keep(double value) {
    sum += value;
    ++count;
}

double Recorder::mean() { return count == 0 ? 0 : sum / count; }

}  // namespace gripper
