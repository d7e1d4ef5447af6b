// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the scripts in deployment/ deploy.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <atomic>
#include <string>
#include <vector>

namespace workcell {

/** Counts what it writes. */
class Producer : public RTT::TaskContext {
public:
    explicit Producer(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addPort("outport", numbers_);
        addProperty("first", next_);
        addProperty("label", label_);
    }
    ~Producer() override { stop(); }

private:
    bool configureHook() override { return next_ >= 0; }
    void updateHook() override { numbers_.write(next_++); }

    RTT::OutputPort<int> numbers_;
    int next_ = 0;
    std::string label_;
};

class Consumer : public RTT::TaskContext {
public:
    explicit Consumer(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addEventPort("inport", numbers_);
        addAttribute("last", last_);
        addOperation("received", [this] { return received_.load(); });
    }
    ~Consumer() override { stop(); }

private:
    bool configureHook() override { return true; }
    void updateHook() override {
        while (numbers_.read(last_) == RTT::NewData) ++received_;
    }

    RTT::InputPort<int> numbers_;
    int last_ = 0;
    std::atomic<int> received_{0};
};

/** An axis that goes where it is told at once. */
class Plant : public RTT::TaskContext {
public:
    explicit Plant(const std::string& name) : RTT::TaskContext(name) {
        addPort("Position", position_);
        addPort("Velocity", velocity_);
        addAttribute("at", at_);
    }
    ~Plant() override { stop(); }

private:
    void updateHook() override {
        double velocity = 0;
        velocity_.read(velocity);
        position_.write(at_ += velocity);
    }

    RTT::OutputPort<double> position_;
    RTT::InputPort<double> velocity_;
    double at_ = 0;
};

class Controller : public RTT::TaskContext {
public:
    explicit Controller(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addPort("SensorValues", sensors_);
        addPort("SteeringSignals", steering_);
        addProperty("K", k_);
        addProperty("joints", joints_);
        addAttribute("mode", mode_);
        provides("limits")->provides("min")->addProperty("velocity", slowest_);
    }
    ~Controller() override { stop(); }

private:
    bool configureHook() override { return k_ > 0; }

    RTT::InputPort<double> sensors_;
    RTT::OutputPort<double> steering_;
    double k_ = 0;
    std::vector<double> joints_;
    std::string mode_;
    double slowest_ = -1;
};

}  // namespace workcell

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(workcell::Producer)
ORO_LIST_COMPONENT_TYPE(workcell::Consumer)
ORO_LIST_COMPONENT_TYPE(workcell::Plant)
ORO_LIST_COMPONENT_TYPE(workcell::Controller)
