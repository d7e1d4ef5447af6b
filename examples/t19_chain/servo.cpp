// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parts of a servo, each of which reads what the one before has written, and a chain of our own.
#include <fbsched/fbsched.hpp>
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <string>

namespace servo {

/** Writes the number of its cycle. */
class Sensor : public RTT::TaskContext {
public:
    explicit Sensor(const std::string& name) : RTT::TaskContext(name) { addPort("position", position_); }
    ~Sensor() override { stopForGood(); }

private:
    void updateHook() override { position_.write(cycle_++); }
    RTT::OutputPort<int> position_;
    int cycle_ = 0;
};

/** Passes on what it reads. */
class Controller : public RTT::TaskContext {
public:
    explicit Controller(const std::string& name) : RTT::TaskContext(name) {
        addPort("position", position_);
        addPort("force", force_);
    }
    ~Controller() override { stopForGood(); }

private:
    void updateHook() override {
        int value = 0;
        if (position_.read(value) == RTT::NewData) force_.write(value);
    }
    RTT::InputPort<int> position_;
    RTT::OutputPort<int> force_;
};

/** Counts the cycles in which it has a new value of the same cycle, and others. */
class Motor : public RTT::TaskContext {
public:
    explicit Motor(const std::string& name) : RTT::TaskContext(name) {
        addPort("force", force_);
        addAttribute("same", same_);
        addAttribute("late", late_);
    }
    ~Motor() override { stopForGood(); }

private:
    void updateHook() override {
        int value = -1;
        force_.read(value);
        ++(value == cycle_++ ? same_ : late_);
    }
    RTT::InputPort<int> force_;
    int cycle_ = 0, same_ = 0, late_ = 0;
};

/** A chain that executes its members ten times. */
class TenTimes : public FBSched {
public:
    explicit TenTimes(const std::string& name) : FBSched(name) { addAttribute("left", left_); }
    ~TenTimes() override { stopForGood(); }

protected:
    bool startHook() override {
        left_ = 10;
        return FBSched::startHook();
    }
    void updateHook() override {
        if (left_ == 0) return;
        FBSched::updateHook();
        --left_;
    }

private:
    int left_ = 0;
};

}  // namespace servo

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(servo::Sensor)
ORO_LIST_COMPONENT_TYPE(servo::Controller)
ORO_LIST_COMPONENT_TYPE(servo::Motor)
ORO_LIST_COMPONENT_TYPE(servo::TenTimes)
