// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Knows the types of messages, but nothing of topics and services: those are a matter of the deployment.
#include <rtt/Component.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>

#include <std_msgs/typekit/Bool.h>

#include <string>

class Thermostat : public RTT::TaskContext {
public:
    explicit Thermostat(const std::string& name) : TaskContext(name) {
        addEventPort("temperature", temperature).doc("Of the room, in degrees Celsius.");
        addPort("heating", heating).doc("Is the heating to be on?");
        addProperty("wanted", wanted).doc("Temperature to hold, in degrees Celsius.");
        addProperty("names", names).doc("Rooms that are heated.");
        addOperation("report", &Thermostat::report, this, RTT::OwnThread).doc("What was measured last.");
    }
    ~Thermostat() override { stopForGood(); }

    void updateHook() override {
        if (temperature.read(last) != RTT::NewData) return;
        std_msgs::Bool on;
        on.data = last < wanted;
        heating.write(on);
    }

private:
    std::string report() { return std::to_string(static_cast<int>(last)) + " degrees in " + names.at(0); }

    RTT::InputPort<double> temperature;
    RTT::OutputPort<std_msgs::Bool> heating;
    double wanted = 20, last = 0;
    std::vector<std::string> names{"nowhere"};
};

ORO_CREATE_COMPONENT(Thermostat)
