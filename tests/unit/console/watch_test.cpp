// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Samples of ports, looked at from the console.
#include "console_fixture.hpp"

#include <console/port_probe.hpp>
#include <console/value_lines.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include <support/real_time_trap.hpp>
#include <types/sample_types.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

namespace {

using OCL::console::PortProbe;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::MatchesRegex;
using testing::Not;

class Samples : public ConsoleTest {
protected:
    Samples() {
        sample::addTypes();
        plant.ports()->addPort("state", state.emplace());
        plant.ports()->addPort("goal", goal);
        tank->ports()->getPort("flow")->connectTo(pump->ports()->getPort("flow"));
    }
    ~Samples() override {
        if (state) plant.ports()->removePort("state");
        plant.ports()->removePort("goal");
    }
    RTT::OutputPort<double>& pumped() {
        return dynamic_cast<RTT::OutputPort<double>&>(*pump->ports()->getPort("flow"));
    }
    RTT::InputPort<double>& flow() { return dynamic_cast<RTT::InputPort<double>&>(*tank->ports()->getPort("flow")); }

    std::optional<RTT::OutputPort<sample::Tank>> state;
    RTT::InputPort<sample::Tank> goal;
};

TEST_F(Samples, OfInputPortsAreListedAndNotTaken) {
    EXPECT_THAT(answer("ls tank"), HasSubstr("    in   flow   double  <- pump.flow   What comes in. [m3/s]\n"));
    pumped().write(0.25);
    EXPECT_THAT(answer("ls tank"), HasSubstr("    in   flow   double  = 0.25  <- pump.flow   What comes in. [m3/s]\n"));
    EXPECT_THAT(answer("cd tank\nls"), HasSubstr("= 0.25  <- pump.flow"));
    EXPECT_THAT(answer("help flow"), HasSubstr("    last sample: 0.25\n"));
    double value = 0;
    EXPECT_EQ(RTT::NewData, flow().read(value));
    EXPECT_EQ(0.25, value);
}

TEST_F(Samples, OfWritersThatNobodyKnowsAreNotListed) {
    RTT::OutputPort<double> foreign("foreign");
    pumped().disconnect();
    ASSERT_TRUE(foreign.createConnection(flow()));
    foreign.write(7.5);
    EXPECT_THAT(answer("ls tank"), Not(HasSubstr("7.5")));
}

TEST_F(Samples, AreShownAsLinesInAPipe) {
    pumped().write(0.25);
    EXPECT_EQ("0.25\n", answer(".watch pump.flow 1"));
    std::atomic<bool> over{false};
    std::thread writer([&] {
        for (double value = 1; !over; value += 1) {
            pumped().write(value);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    });
    const std::string shown = answer(".watch pump.flow 3");
    over = true;
    writer.join();
    EXPECT_THAT(shown, MatchesRegex("[0-9.]+\n[0-9]+\n[0-9]+\n"));
    EXPECT_EQ("", err.str());
}

TEST_F(Samples, NoConnectionIsLeft) {
    pumped().write(0.25);
    const auto ports = [this] {
        const std::string all = answer("ls pump");
        return all.substr(all.find("Ports"));
    };
    const std::string before = ports();
    answer(".watch pump.flow 1");
    EXPECT_EQ(before, ports());
    EXPECT_EQ(1u, pumped().getManager()->getConnections().size());
    double value = 0;
    EXPECT_EQ(RTT::NewData, flow().read(value));
    EXPECT_THAT(browser.ports()->getPortNames(), ElementsAre());
}

TEST_F(Samples, TheRateIsThatOfTheWriter) {
    std::atomic<bool> over{false};
    std::thread writer([&] {
        while (!over) {
            pumped().write(1);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    });
    const std::string shown = answer(".hz pump.flow 1");
    over = true;
    writer.join();
    double rate = 0, shortest = 0, longest = 0;
    unsigned samples = 0;
    ASSERT_EQ(4, std::sscanf(shown.c_str(), "%lf Hz, intervals %lf ms to %lf ms, %u samples", &rate, &shortest,
                             &longest, &samples))
        << shown;
    EXPECT_LE(rate, 100);
    EXPECT_GE(shortest, 10);
    EXPECT_GE(longest, shortest);
    EXPECT_LE(samples, 130u);
    EXPECT_EQ("0 samples\n", answer(".hz pump.flow 1")) << "the last sample is not a new one";
}

TEST_F(Samples, WhatCannotBeWatchedIsAnError) {
    EXPECT_THAT(complaint(".watch pump.flow"), HasSubstr("expected a number, because no key ends the command here"));
    EXPECT_THAT(complaint(".watch"), HasSubstr("expected the path of an output port"));
    EXPECT_THAT(complaint(".watch pump.flow 0"), HasSubstr("expected a number from 1 to 1000000, found '0'"));
    EXPECT_THAT(complaint(".hz pump.flow -1"), HasSubstr("expected a number from 1 to 1000000, found '-1'"));
    EXPECT_THAT(complaint(".hz pump.flow 99999999999999999999999"), HasSubstr("expected a number from 1 to 1000000"));
    EXPECT_THAT(complaint(".watch pump.flwo 1"), HasSubstr("'pump' has no port 'flwo'; did you mean 'flow'?"));
    EXPECT_THAT(complaint(".watch tank.flow 1"),
                HasSubstr("'tank.flow' is an input port, expected an output port, as 'pump.flow', which writes to it"));
    EXPECT_THAT(complaint(".hz goal 1"), HasSubstr("'goal' is an input port, expected an output port\n"));
}

TEST_F(Samples, APortThatGoesEndsTheCommand) {
    std::thread other([&] {
        while (state->getManager()->getConnections().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        plant.ports()->removePort("state");
        state.reset();
    });
    EXPECT_THAT(complaint(".watch state 5"), HasSubstr("'state' is gone, or was disconnected from all ports"));
    other.join();
}

TEST_F(Samples, SeveralWritersAreCounted) {
    std::string why;
    const auto probe = PortProbe::make(pumped(), PortProbe::From::NextSample, why);
    ASSERT_TRUE(probe) << why;
    constexpr unsigned kEach = 400;
    std::thread one([&] {
        for (unsigned i = 0; i != kEach; ++i) pumped().write(i);
    });
    std::thread two([&] {
        for (unsigned i = 0; i != kEach; ++i) pumped().write(i);
    });
    one.join();
    two.join();
    EXPECT_EQ(2 * kEach, probe->intervals().samples);
    EXPECT_LE(probe->intervals().shortest, probe->intervals().longest);
    unsigned read = 0;
    while (probe->read()) ++read;
    EXPECT_EQ(2 * kEach, read + probe->dropped());
}

TEST_F(Samples, WritingIsRealTimeSafeMeanwhile) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    std::string why;
    const auto probe = PortProbe::make(pumped(), PortProbe::From::LastSample, why);
    ASSERT_TRUE(probe) << why;
    pumped().write(0);  // makes what threads keep
    {
        const oroforge::test::RealTimeTrap trap;
        for (int i = 0; i != 2000; ++i) pumped().write(i);  // more than there is room for
    }
    EXPECT_EQ(2001u, probe->intervals().samples);
    EXPECT_GT(probe->dropped(), 0u);
}

TEST_F(Samples, PartsOfTheLastOneAreExpressionsAndAreCompleted) {
    sample::Tank full;
    full.position.y = 2.5;
    state->write(full);
    EXPECT_EQ(" = 2.5\n", answer("state.last.position.y"));
    EXPECT_EQ(" = 3.5\n", answer("state.last.position.y + 1.0"));
    EXPECT_THAT(console->complete("state.last.").words, IsSupersetOf({"id", "label", "position", "call", "send"}));
    EXPECT_THAT(console->complete("1.0 + state.last.pos").words, ElementsAre("position"));
    EXPECT_THAT(console->complete("state.last.position.").words, ElementsAre("x", "y"));
    EXPECT_THAT(console->complete("state.last.position.x.").words, ElementsAre());
    EXPECT_THAT(console->complete("tank.fill.").words, ElementsAre("call", "cmd", "send"));
}

TEST_F(Samples, AStructThatIsWiderThanTheTerminalHasALineForEachMember) {
    sample::Tank full;
    full.label = "water";
    full.levels = {1, 2};
    full.path = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
    state->write(full);
    const std::string whole = answer("state.last");
    EXPECT_THAT(whole, testing::StartsWith(" = {id = 0, label = \"water\", "));
    EXPECT_EQ(1, std::count(whole.begin(), whole.end(), '\n')) << "a program reads it";
    console->screen().cutsTables = true;
    console->screen().width = [] { return std::size_t(40); };
    EXPECT_EQ(
        " =\n"
        "    id = 0\n"
        "    label = \"water\"\n"
        "    position = {x = 0, y = 0}\n"
        "    levels = [1, 2]\n"
        "    path\n"
        "      [0] = {x = 1, y = 2}\n"
        "      [1] = {x = 3, y = 4}\n"
        "      [2] = {x = 5, y = 6}\n"
        "      [3] = {x = 7, y = 8}\n"
        "    weights = [0, 0, 0]\n"
        "    pair = [0, 0]\n"
        "    mode = Idle\n"
        "    small = 0\n"
        "    flags = []\n",
        answer("state.last"));
    EXPECT_EQ(" = {x = 0, y = 0}\n", answer("state.last.position"));
    full.path.assign(25, {1, 2});
    state->write(full);
    EXPECT_THAT(answer("state.last"), HasSubstr("      [9] = {x = 1, y = 2}\n      … 15 more\n"));
}

TEST_F(Samples, LinesOfAStructHaveALimit) {
    RTT::PropertyBag bag;
    int value = 1;
    for (int i = 0; i != 100; ++i) bag.addProperty("number_" + std::to_string(i), value);
    RTT::Property<RTT::PropertyBag> inner("inner", "", bag);
    RTT::PropertyBag outer;
    outer.addProperty(inner);
    const RTT::base::DataSourceBase::shared_ptr source = new RTT::internal::ValueDataSource<RTT::PropertyBag>(outer);
    const auto lines = OCL::console::valueLines(source, false, 40, 10);
    ASSERT_EQ(10u, lines.size());
    EXPECT_EQ("inner", lines[0]);
    EXPECT_EQ("  number_0 = 1", lines[1]);
    EXPECT_EQ("… 92 more lines", lines[9]);
}

}  // namespace
