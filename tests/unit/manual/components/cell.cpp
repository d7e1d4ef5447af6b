// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The controller and the plant of the deployment manual's example: a motor whose position is to follow a reference.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <iostream>

namespace cell {

class Controller : public RTT::TaskContext {
public:
    explicit Controller(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addProperty("K", gain_).doc("The gain.");
        addProperty("Limit", limit_).doc("The largest signal.");
        addProperty("Reference", reference_).doc("Where the plant is to be.");
        addPort("SensorValues", sensor_).doc("The position of the plant.");
        addPort("SteeringSignals", signals_).doc("The speed that the plant is to have.");
        addOperation("hasReached", &Controller::hasReached, this).doc("True once the plant is where it should be.");
    }

protected:
    bool configureHook() override {
        std::cout << getName() + ": K = " + std::to_string(gain_) + ", Limit = " + std::to_string(limit_) + "\n"
                  << std::flush;
        return true;
    }
    void updateHook() override {
        while (sensor_.read(position_) == RTT::NewData) {
        }
        const double wanted = gain_ * (reference_ - position_);
        signals_.write(wanted > limit_ ? limit_ : wanted < -limit_ ? -limit_ : wanted);
    }

private:
    bool hasReached() const { return reference_ - position_ < 0.01 && position_ - reference_ < 0.01; }

    double gain_ = 0, limit_ = 1, reference_ = 1, position_ = 0;
    RTT::InputPort<double> sensor_;
    RTT::OutputPort<double> signals_;
};

/** Without a period: a new speed moves it. */
class Plant : public RTT::TaskContext {
public:
    explicit Plant(const std::string& name) : RTT::TaskContext(name) {
        addPort("Position", out_);
        addEventPort("Velocity", in_);
    }

protected:
    void updateHook() override {
        double velocity = 0;
        if (in_.read(velocity) != RTT::NewData) return;
        position_ += velocity * 0.05;
        out_.write(position_);
    }

private:
    double position_ = 0;
    RTT::OutputPort<double> out_;
    RTT::InputPort<double> in_;
};

}  // namespace cell

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(cell::Controller)
ORO_LIST_COMPONENT_TYPE(cell::Plant)
