// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a row costs the reporter's own thread: no allocation, no lock, and none is lost.
#include "reporter_fixture.hpp"

#include <support/real_time_trap.hpp>

#include <algorithm>

namespace {

using namespace components_test;
using oroforge::test::expectRealTime;

class ReportRealTime : public Reporting {
protected:
    static constexpr int kPorts = 1000;

    void SetUp() override {
        Reporting::SetUp();
        for (int i = 0; i < kPorts; ++i) {
            ports_.push_back(std::make_unique<RTT::OutputPort<double>>("p" + std::to_string(i)));
            many_.addPort(*ports_.back());
        }
        reporter->addPeer(&many_);
        ASSERT_TRUE(reporter->reportComponent("Many"));
    }
    void write(double value) {
        for (const auto& port : ports_) port->write(value);
    }

    RTT::TaskContext many_{"Many"};
    std::vector<std::unique_ptr<RTT::OutputPort<double>>> ports_;
};

TEST_F(ReportRealTime, ARowOfAThousandPortsAllocatesAndLocksNothing) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    machine.levels.write(std::vector<double>(20, 0.5));
    machine.place.write({1, 2});
    for (const char* port : {"levels", "place", "mode"}) ASSERT_TRUE(reporter->reportPort("Machine", port));
    ASSERT_TRUE(reporter->reportData("Machine", "label"));
    ASSERT_TRUE(reporter->start());
    cycle();
    for (int i = 0; i < 20; ++i) {
        write(i * 0.25);
        machine.place.write({1.0 * i, 2});
        machine.levels.write(std::vector<double>(20, i));
        machine.mode.write(sample::Mode::Draining);
        expectRealTime([this] { reporter->update(); });
    }
}

TEST_F(ReportRealTime, NoRowIsLostUnderLoad) {
    constexpr int kRows = 1000;  // a second of them at 1 kHz, as fast as they can be made
    ASSERT_TRUE(reporter->start());
    for (int i = 0; i < kRows; ++i) {
        write(i);
        cycle(0.001);
    }
    const std::string lines = report();
    EXPECT_EQ(kRows + 2, std::count(lines.begin(), lines.end(), '\n'));
    std::string expected = " 1";
    for (int i = 0; i < kPorts; ++i) expected += " 999";
    EXPECT_EQ(expected + " \n", lines.substr(lines.rfind('\n', lines.size() - 2) + 1));
}

}  // namespace
