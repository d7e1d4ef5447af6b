// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An arm that moves towards its goal by a quarter of a radian in each cycle.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <t13_old_scripts/pose.hpp>

#include <algorithm>
#include <iostream>

namespace arm {

class Arm : public RTT::TaskContext {
public:
    explicit Arm(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addProperty("goal", goal).doc("The goal of the shoulder, in rad.");
        addAttribute("broken", broken);
        addPort("pose", pose).doc("Where the arm is.");
        addOperation("say", &Arm::say, this).doc("Prints a line.").arg("what", "");
    }
    ~Arm() override { stopForGood(); }

private:
    void updateHook() override {
        now.shoulder.q += std::clamp(goal - now.shoulder.q, -0.25, 0.25);
        pose.write(now);
    }
    void say(const std::string& what) { std::cout << getName() << ": " << what << std::endl; }

    Pose now;
    double goal = 0;
    bool broken = false;
    RTT::OutputPort<Pose> pose;
};

}  // namespace arm

ORO_CREATE_COMPONENT(arm::Arm)
