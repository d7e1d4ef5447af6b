// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that publishes, serves, and waits for a service.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <iostream>

class Waiting : public RTT::TaskContext {
public:
    explicit Waiting(const std::string& name) : TaskContext(name) {
        addPort("out", out_);
        addEventPort("in", in_);
        addOperation("answer", &Waiting::answer, this, RTT::OwnThread);
        addOperation("here", &Waiting::answer, this, RTT::ClientThread);
        requires()->addOperationCaller(ask_);
    }
    ~Waiting() override { stopForGood(); }
    void updateHook() override {
        out_.write(++cycles_);
        if (cycles_ != 5) return;
        std::cout << getName() + " waits\n" << std::flush;
        if (ask_.ready()) (void)ask_();
    }

private:
    bool answer() { return true; }

    RTT::OutputPort<double> out_;
    RTT::InputPort<double> in_;
    RTT::OperationCaller<bool()> ask_{"ask"};
    double cycles_ = 0;
};

ORO_CREATE_COMPONENT(Waiting)
