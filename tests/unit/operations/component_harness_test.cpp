// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/ComponentHarness.hpp>

#include <gtest/gtest.h>

namespace {

using RTT::extras::ComponentHarness;

/// Doubles what it reads, and notes when.
class Doubler : public RTT::TaskContext {
public:
    explicit Doubler(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addEventPort(in);
        addPort(out);
        addOperation("updates", &Doubler::updates, this, RTT::OwnThread);
        addOperation("sum", &Doubler::sum, this, RTT::ClientThread);
    }
    ~Doubler() override { stop(); }

    int updates() { return updates_; }
    double sum(int a, double b) { return a + b; }
    void updateHook() override {
        ++updates_;
        times.push_back(RTT::os::TimeService::Instance()->getSeconds());
        double sample = 0;
        while (in.read(sample) == RTT::NewData) out.write(2 * sample);
    }

    RTT::InputPort<double> in{"in"};
    RTT::OutputPort<double> out{"out"};
    std::vector<double> times;

private:
    int updates_ = 0;
};

TEST(ComponentHarness, StepsAComponentThroughTime) {
    Doubler component("doubler");
    ComponentHarness harness(component, 0.25);
    ASSERT_TRUE(harness.start());

    harness.step();
    harness.step(1.0);

    ASSERT_EQ(component.times.size(), 5u);
    EXPECT_DOUBLE_EQ(component.times[4] - component.times[0], 1.0);
}

TEST(ComponentHarness, TimePassesAgainAfterwards) {
    {
        Doubler component("doubler");
        ComponentHarness harness(component);
    }
    EXPECT_TRUE(RTT::os::TimeService::Instance()->systemClockEnabled());
}

TEST(ComponentHarness, PortsAreFedAndRead) {
    Doubler component("doubler");
    ComponentHarness harness(component);
    auto& in = harness.input<double>("in");
    auto& out = harness.output<double>("out");
    EXPECT_THROW(out.last(), std::logic_error);
    ASSERT_TRUE(harness.start());

    for (const double sample : {1.0, 2.0, 3.0}) {
        in.write(sample);
        harness.step();
    }

    EXPECT_EQ(out.all(), (std::vector<double>{2.0, 4.0, 6.0}));
    EXPECT_EQ(out.last(), 6.0);
    EXPECT_EQ(&harness.input<double>("in"), &in);
}

TEST(ComponentHarness, OperationsAreCalledWhoseverThreadTheyWant) {
    Doubler component("doubler");
    ComponentHarness harness(component);
    ASSERT_TRUE(harness.start());
    harness.step();

    EXPECT_EQ(harness.call<int()>("updates"), 1);
    EXPECT_EQ(harness.call<double(int, double)>("sum", 1, 0.5), 1.5);
}

TEST(ComponentHarness, NamesThatDoNotFitAreTold) {
    Doubler component("doubler");
    ComponentHarness harness(component);

    EXPECT_THROW(harness.input<double>("inn"), std::logic_error);
    EXPECT_THROW(harness.input<int>("in"), std::logic_error);
    EXPECT_THROW(harness.output<double>("in"), std::logic_error);
    EXPECT_THROW(harness.call<int()>("updats"), std::logic_error);
    EXPECT_THROW(harness.call<double(std::string)>("sum", "a"), std::logic_error);
}

TEST(ComponentHarness, SeveralComponentsStepTogether) {
    Doubler first("first");
    Doubler second("second");
    ComponentHarness harness(first);
    harness.add(second);
    first.out.connectTo(&second.in);
    auto& in = harness.input<double>("in");
    ASSERT_TRUE(harness.start());

    in.write(1.5);
    harness.step();

    double sample = 0;
    EXPECT_EQ(second.in.read(sample), RTT::OldData);
    EXPECT_EQ(sample, 3.0);
}

TEST(ComponentHarness, ARunningComponentIsRefused) {
    Doubler component("doubler");
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());

    EXPECT_THROW(ComponentHarness{component}, std::logic_error);
}

}  // namespace
