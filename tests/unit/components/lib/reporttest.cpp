// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components for the reporters' process tests.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace reporttest {

/** Writes the number of its cycle to as many ports as the property says. */
class Counter : public RTT::TaskContext {
public:
    explicit Counter(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addProperty("ports", ports_);
        addProperty("tell", tell_).doc("After that many cycles it says so");
        addProperty("gain", gain_);
        addPort("text", text_);
    }

private:
    bool configureHook() override {
        for (int i = 0; i < ports_; ++i) {
            numbers_.push_back(std::make_unique<RTT::OutputPort<double>>("n" + std::to_string(i)));
            addPort(*numbers_.back());
        }
        return true;
    }
    void updateHook() override {
        ++cycle_;
        for (const auto& port : numbers_) port->write(cycle_);
        if (cycle_ == tell_) std::cout << getName() + ": " + std::to_string(tell_) + " cycles\n" << std::flush;
    }
    void cleanupHook() override { numbers_.clear(); }

    int ports_ = 1;
    int tell_ = 100;
    double gain_ = 0.5;
    int cycle_ = 0;
    std::vector<std::unique_ptr<RTT::OutputPort<double>>> numbers_;
    RTT::OutputPort<std::string> text_;
};

/** Writes texts that are hard to read, and a sequence that grows and shrinks. */
class Grower : public RTT::TaskContext {
public:
    explicit Grower(const std::string& name) : RTT::TaskContext(name) {
        addPort("count", count_);
        addPort("text", text_);
        addPort("twice", twice_);
        addPort("levels", levels_);
        addOperation("step", &Grower::step, this).doc("Writes new values to all ports.");
    }

private:
    void step() {
        ++cycle_;
        std::vector<double> levels(static_cast<std::size_t>(cycle_ < 100 ? 0 : cycle_ / 250 % 7));
        for (std::size_t i = 0; i != levels.size(); ++i) levels[i] = cycle_ + static_cast<double>(i) / 3;
        text_.write("say \"" + std::to_string(cycle_) + "\",\nblank ");
        twice_.write(2 * cycle_);
        levels_.write(levels);
        count_.write(cycle_);
        if (cycle_ == kEnd) std::cout << "grown\n" << std::flush;
    }

    static constexpr int kEnd = 2000;
    int cycle_ = 0;
    RTT::OutputPort<double> count_, twice_;
    RTT::OutputPort<std::string> text_;
    RTT::OutputPort<std::vector<double>> levels_;
};

}  // namespace reporttest

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(reporttest::Counter)
ORO_LIST_COMPONENT_TYPE(reporttest::Grower)
