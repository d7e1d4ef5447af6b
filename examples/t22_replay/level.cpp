// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A sensor that measures the level of a tank, and a controller that holds it.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <rtt/os/TimeService.hpp>

#include <cmath>
#include <random>
#include <string>

namespace level {

/** Never measures the same twice. */
class Sensor : public RTT::TaskContext {
public:
    explicit Sensor(const std::string& name) : RTT::TaskContext(name), measured("measured") {
        addProperty("samples", samples).doc("After so many it stops.");
        addPort(measured).doc("The level, in metres.");
    }

private:
    void updateHook() override {
        measured.write(1 + 0.2 * std::sin(0.1 * count) + noise(random));
        if (++count == samples) stop();
    }

    int samples = 50, count = 0;
    std::random_device random;
    std::normal_distribution<double> noise{0, 0.01};
    RTT::OutputPort<double> measured;
};

/** Adds up the error over time, which it asks the runtime for: a replay repeats that, too. */
class Controller : public RTT::TaskContext {
public:
    explicit Controller(const std::string& name) : RTT::TaskContext(name), measured("measured"), valve("valve") {
        addProperty("gain", gain).doc("How far the valve opens for an error of a metre.");
        addProperty("gainOfSum", gainOfSum).doc("The same for an error of a metre for a second.");
        addEventPort(measured).doc("The level, in metres.");
        addPort(valve).doc("How far the valve is open.");
    }

private:
    bool startHook() override {
        last = RTT::os::TimeService::Instance()->getSeconds();
        return true;
    }

    void updateHook() override {
        double level = 0;
        if (measured.read(level) != RTT::NewData) return;
        const double now = RTT::os::TimeService::Instance()->getSeconds();
        sum += (1 - level) * (now - last);
        last = now;
        valve.write(gain * (1 - level) + gainOfSum * sum);
    }

    double gain = 2, gainOfSum = 0.5;
    double sum = 0, last = 0;
    RTT::InputPort<double> measured;
    RTT::OutputPort<double> valve;
};

}  // namespace level

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(level::Sensor)
ORO_LIST_COMPONENT_TYPE(level::Controller)
