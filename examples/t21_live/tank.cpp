// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A tank that is filled and empties itself: something to look at.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <string>

namespace live {

class Tank : public RTT::TaskContext {
public:
    explicit Tank(const std::string& name) : TaskContext(name, PreOperational) {
        addProperty("capacity", capacity_).doc("What it holds. [m3]");
        addProperty("leak", leak_).doc("Part of its level that it loses in a step.");
        addPort("level", level_).doc("What is in it. [m3]");
        addOperation("fill", &Tank::fill, this, RTT::OwnThread)
            .doc("Fills it up to a level. False if that is more than it holds.")
            .arg("level", "in m3");
    }
    ~Tank() override { stopForGood(); }

private:
    bool configureHook() override { return capacity_ > 0; }
    void updateHook() override {
        now_ -= now_ * leak_;
        level_.write(now_);
    }

    bool fill(double level) {
        if (level > capacity_) return false;
        now_ = level;
        return true;
    }

    double capacity_ = 0, leak_ = 0, now_ = 0;
    RTT::OutputPort<double> level_;
};

}  // namespace live

ORO_CREATE_COMPONENT(live::Tank)
