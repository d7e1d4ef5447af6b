// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A tank and the pump that fills it: something to look at and to command.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <string>

namespace filling {

class Tank : public RTT::TaskContext {
public:
    explicit Tank(const std::string& name) : TaskContext(name, PreOperational) {
        addProperty("capacity", capacity_).doc("What it holds. [m3]");
        addProperty("label", label_).doc("What is written on its side.");
        addAttribute("fillings", fillings_);
        addPort("flow", flow_).doc("What comes in. [m3/s]");
        addPort("level", level_).doc("What is in it. [m3]");
        addOperation("fill", &Tank::fill, this, RTT::OwnThread)
            .doc("Fills it up to a level. False if that is more than it holds.")
            .arg("level", "in m3");
        addOperation("empty", &Tank::empty, this).doc("Empties it.");
        level_.keepLastWrittenValue(true);
    }
    ~Tank() override { stopForGood(); }

private:
    bool configureHook() override { return capacity_ > 0; }
    bool startHook() override {
        level_.write(0);
        return true;
    }

    bool fill(double level) {
        if (level > capacity_) return false;
        ++fillings_;
        level_.write(level);
        return true;
    }
    void empty() { level_.write(0); }

    double capacity_ = 0;
    std::string label_ = "water";
    int fillings_ = 0;
    RTT::InputPort<double> flow_;
    RTT::OutputPort<double> level_;
};

class Pump : public RTT::TaskContext {
public:
    explicit Pump(const std::string& name) : TaskContext(name) { addPort("flow", flow_).doc("What it moves. [m3/s]"); }
    ~Pump() override { stopForGood(); }

private:
    RTT::OutputPort<double> flow_;
};

}  // namespace filling

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(filling::Tank)
ORO_LIST_COMPONENT_TYPE(filling::Pump)
