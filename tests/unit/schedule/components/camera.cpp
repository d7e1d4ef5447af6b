// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a replay replaces: a component with outputs only. Its library need not be there then.
#include "Pose.hpp"

#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <cmath>
#include <ctime>

namespace replaytest {

class Camera : public RTT::TaskContext {
public:
    explicit Camera(const std::string& name) : RTT::TaskContext(name) {
        addProperty("exposure", exposure_);
        addPort("image", image_);
        addPort("pose", pose_);
        provides("debug")->addPort("level", level_);
        image_.setDataSample("012345678901234567890123456789");
    }
    ~Camera() override { stopForGood(); }

private:
    void updateHook() override {
        timespec now{};
        clock_gettime(CLOCK_MONOTONIC, &now);
        image_.write("image " + std::to_string(++count_) + " " + std::to_string(now.tv_nsec));
        Pose pose;
        pose.x = std::sin(count_);
        pose_.write(pose);
        level_.write(count_);
    }

    double exposure_ = 1;
    int count_ = 0;
    RTT::OutputPort<std::string> image_;
    RTT::OutputPort<Pose> pose_;
    RTT::OutputPort<int> level_;
};

}  // namespace replaytest

ORO_CREATE_COMPONENT(replaytest::Camera)
