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

}  // namespace reporttest

ORO_CREATE_COMPONENT(reporttest::Counter)
