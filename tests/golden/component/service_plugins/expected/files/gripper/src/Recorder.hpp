#ifndef GRIPPER_RECORDER_HPP
#define GRIPPER_RECORDER_HPP

#include <gripper/RecorderBase.hpp>

namespace gripper {

/// Keeps what was measured.
/// Ports, properties and attributes are members of the base class: RecorderBase, generated from gripper.xml.
class Recorder : public RecorderBase {
public:
    explicit Recorder(RTT::TaskContext* owner);

    void forget() override;

    /// Of all samples.
    double mean() override;
};

}  // namespace gripper

#endif
