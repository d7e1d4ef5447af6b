// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component library written without the macros and their header. Its port has a type of its own.
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>

namespace {

struct Sample {
    double values[3];
};

class Handwritten : public RTT::TaskContext {
public:
    explicit Handwritten(const std::string& name) : RTT::TaskContext(name) {
        addPort("in", in_);
        addPort("out", out_);
    }

private:
    RTT::InputPort<Sample> in_;
    RTT::OutputPort<Sample> out_;
};

}  // namespace

extern "C" {
RTT_EXPORT RTT::TaskContext* createComponent(std::string name) { return new Handwritten(name); }
RTT_EXPORT std::string getComponentType() { return "loading_test::Handwritten"; }
}
