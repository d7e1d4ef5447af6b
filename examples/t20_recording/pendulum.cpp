// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A pendulum that swings when it is told to.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace swing {

class Pendulum : public RTT::TaskContext {
public:
    explicit Pendulum(const std::string& name) : RTT::TaskContext(name), angle("angle"), energies("energies") {
        addProperty("length", length).doc("Its length, in metres.");
        addPort(angle).doc("Its angle, in radians.");
        addPort(energies).doc("Its potential and kinetic energy, in joules per kilogram.");
        energies.setDataSample({0, 0});  // two elements: buffers have room for them
        addOperation("swing", &Pendulum::swing, this, RTT::OwnThread)
            .doc("Swings for a while.")
            .arg("seconds", "How long");
    }

private:
    void swing(double seconds) {
        constexpr double kStep = 0.001, kGravity = 9.81;
        for (double left = seconds; left > 0; left -= kStep) {
            speed -= kGravity / length * std::sin(position) * kStep;
            position += speed * kStep;
        }
        angle.write(position);
        energies.write({kGravity * length * (1 - std::cos(position)), 0.5 * length * length * speed * speed});
    }

    double length = 1;
    double position = 0.5, speed = 0;
    RTT::OutputPort<double> angle;
    RTT::OutputPort<std::vector<double>> energies;
};

}  // namespace swing

ORO_CREATE_COMPONENT(swing::Pendulum)
