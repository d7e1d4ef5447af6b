#include "Recorder.hpp"

namespace gripper {

Recorder::Recorder(RTT::TaskContext* owner) : RecorderBase(owner) {}

void Recorder::forget() {
}

double Recorder::mean() {
    return {};
}

}  // namespace gripper
