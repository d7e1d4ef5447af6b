// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is reported, and what is said if it cannot be.
#include "reporter_fixture.hpp"

#include <thread>

namespace {

using namespace components_test;

class ReportEntries : public Reporting {
protected:
    std::string header() {
        property<bool>("Decompose") = false;
        EXPECT_TRUE(reporter->start());
        const std::string lines = report();
        return lines.substr(0, lines.find('\n'));
    }
    /** "Kind=value" of each entry of ReportData. */
    std::string entries() {
        std::string result;
        for (const auto* entry : property<RTT::PropertyBag>("ReportData"))
            result += entry->getName() + "=" + entry->getDataSource()->toString() + " ";
        return result;
    }
};

TEST_F(ReportEntries, ConfigureTakesThemFromReportData) {
    entry("Component", "Machine");
    entry("Data", "Machine.gain");
    entry("Port", "Machine.motor.current");
    ASSERT_TRUE(reporter->configure());
    EXPECT_EQ(
        " TimeStamp Machine.speed Machine.place Machine.levels Machine.tank Machine.mode Machine.gain"
        " Machine.motor.current",
        header());
}

TEST_F(ReportEntries, NamesOfPortsAndValuesMayHaveDots) {
    RTT::OutputPort<double> angle;
    RTT::Property<double> limit("angle.limit", "", 2);
    machine.addPort("motor.angle", angle);
    machine.provides("motor")->addProperty(limit);
    entry("Port", "Machine.motor.angle");
    entry("Data", "Machine.motor.angle.limit");
    ASSERT_TRUE(reporter->configure());
    EXPECT_EQ(" TimeStamp Machine.motor.angle Machine.motor.angle.limit", header());
    reporter->stop();
    machine.ports()->removePort("motor.angle");
    machine.provides("motor")->removeProperty(limit);
}

TEST_F(ReportEntries, NothingToReportIsAnError) {
    const LogText log;
    EXPECT_FALSE(reporter->configure());
    EXPECT_THAT(log(), HasSubstr("the property ReportData is empty"));
    EXPECT_THAT(log(), HasSubstr("marshalling.loadProperties()"));
}

TEST_F(ReportEntries, AllBadEntriesAreReported) {
    const LogText log;
    entry("Port", "Machine");
    entry("Ports", "Machine.speed");
    entry("Component", "Machin");
    entry("Port", "Machine.sped");
    entry("Port", "Machine.setpoint");
    property<RTT::PropertyBag>("ReportData").ownProperty(new RTT::Property<int>("Data", "", 3));
    EXPECT_FALSE(reporter->configure());
    const std::string said = log();
    EXPECT_THAT(said, HasSubstr("found 'Machine', expected the name of a component, a dot"));
    EXPECT_THAT(said,
                HasSubstr("found name \"Ports\", expected \"Component\", \"Port\" or \"Data\"; did you mean 'Port'?"));
    EXPECT_THAT(
        said,
        HasSubstr("could not report component 'Machin': no such peer; its peers: Machine; did you mean 'Machine'?"));
    EXPECT_THAT(said, HasSubstr("no such port on component 'Machine'; did you mean 'speed'?"));
    EXPECT_THAT(said, HasSubstr("cannot report input port 'setpoint'"));
    EXPECT_THAT(said, HasSubstr("property \"Data\" of ReportData: found type int, expected string"));
}

TEST_F(ReportEntries, UnknownDataIsAnErrorInTheLogOnly) {
    const LogText log;
    EXPECT_TRUE(reporter->reportData("Machine", "again"));
    EXPECT_THAT(log(), HasSubstr("could not report 'again': no such property or attribute of component 'Machine'"));
    EXPECT_THAT(log(), HasSubstr("; did you mean 'gain'?"));
    EXPECT_EQ("", entries());
}

struct Unregistered {};

TEST_F(ReportEntries, PortsOfUnknownTypesAreRefused) {
    const LogText log;
    RTT::OutputPort<Unregistered> strange("strange");
    machine.addPort(strange);
    EXPECT_FALSE(reporter->reportPort("Machine", "strange"));
    EXPECT_THAT(log(), HasSubstr("could not report 'Machine.strange': unknown type"));
    EXPECT_EQ(nullptr, reporter->getPort("Machine_strange"));
}

TEST_F(ReportEntries, AComponentIsReportedWithoutItsPortsOfUnknownTypes) {
    const LogText log;
    RTT::OutputPort<Unregistered> strange("strange");
    machine.addPort(strange);
    EXPECT_TRUE(reporter->reportComponent("Machine"));
    EXPECT_THAT(log(), HasSubstr("could not report 'Machine.strange': unknown type"));
    EXPECT_EQ("Component=Machine ", entries());
    ASSERT_TRUE(reporter->cleanup());
    entry("Component", "Machine");
    EXPECT_TRUE(reporter->configure());
    EXPECT_EQ(" TimeStamp Machine.speed Machine.place Machine.levels Machine.tank Machine.mode", header());
}

TEST_F(ReportEntries, OperationsKeepReportDataUpToDate) {
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    ASSERT_TRUE(reporter->reportComponent("Machine"));
    EXPECT_EQ("Port=Machine.speed Data=Machine.gain Component=Machine ", entries());
    EXPECT_TRUE(reporter->unreportPort("Machine", "speed"));
    EXPECT_FALSE(reporter->unreportPort("Machine", "speed"));
    EXPECT_TRUE(reporter->unreportData("Machine", "gain"));
    EXPECT_EQ("Component=Machine ", entries());
    EXPECT_EQ(nullptr, reporter->getPort("Machine_speed"));
    EXPECT_TRUE(reporter->unreportComponent("Machine"));
    EXPECT_FALSE(reporter->unreportComponent("Machine"));
    EXPECT_EQ("", entries());
    EXPECT_EQ(" TimeStamp", header());
}

TEST_F(ReportEntries, AComponentWithoutPortsIsReportedUntilItIsUnreported) {
    RTT::TaskContext other("Other");
    reporter->addPeer(&other);
    ASSERT_TRUE(reporter->reportComponent("Other"));
    EXPECT_EQ("Component=Other ", entries());
    EXPECT_TRUE(reporter->unreportComponent("Other"));
    EXPECT_FALSE(reporter->unreportComponent("Other"));
    EXPECT_EQ("", entries());
}

TEST_F(ReportEntries, ReportingAgainReplacesThePort) {
    const LogText log;
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    EXPECT_THAT(log(), HasSubstr("already reporting 'Machine.speed': removing the old port first"));
    EXPECT_EQ(" TimeStamp Machine.speed", header());
    EXPECT_EQ("Port=Machine.speed ", entries());
}

TEST_F(ReportEntries, ConfigureKeepsWhatWasReportedBefore) {
    const LogText log;
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->configure());
    EXPECT_EQ("", log());
    EXPECT_EQ("Port=Machine.speed ", entries());
    EXPECT_EQ(" TimeStamp Machine.speed", header());
}

TEST_F(ReportEntries, ConfigureConnectsAPortAnewWhoseComponentWasReplaced) {
    auto other = std::make_unique<Machine>();
    reporter->removePeer("Machine");
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    other = std::make_unique<Machine>();
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->configure());
    EXPECT_TRUE(other->speed.connected());
    EXPECT_EQ("Port=Machine.speed ", entries());
    EXPECT_EQ(" TimeStamp Machine.speed", header());
    reporter->removePeer("Machine");
}

TEST_F(ReportEntries, ATakenNameGetsThePortAlsoWhileTheOldComponentLives) {
    for (const char* port : {"speed", "mode"}) ASSERT_TRUE(reporter->reportPort("Machine", port));
    Machine other;
    reporter->removePeer("Machine");
    reporter->addPeer(&other);
    ASSERT_TRUE(reporter->configure());
    EXPECT_FALSE(machine.speed.connected());
    EXPECT_TRUE(other.speed.connected());
    reporter->removePeer("Machine");
    reporter->addPeer(&machine);
    machine.speed.write(7);
    ASSERT_TRUE(reporter->start());
    EXPECT_FALSE(other.speed.connected());
    EXPECT_EQ(" TimeStamp Machine.speed Machine.mode\n 0 7 Idle \n", report());
}

TEST_F(ReportEntries, ColumnsKeepTheirPlaceWhenTheirSourceIsReplaced) {
    auto other = std::make_unique<Machine>();
    reporter->removePeer("Machine");
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    ASSERT_TRUE(reporter->reportComponent("Machine"));
    const std::string before = entries(), columns = header();
    EXPECT_EQ(0u, columns.find(" TimeStamp Machine.speed Machine.gain Machine.place"));
    other = std::make_unique<Machine>();
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->configure());
    EXPECT_EQ(before, entries());
    text.str("");
    EXPECT_EQ(columns, header());
    reporter->reportPort("Machine", "speed");
    reporter->reportData("Machine", "gain");
    EXPECT_EQ(before, entries());
    text.str("");
    EXPECT_EQ(columns, header());
    reporter->removePeer("Machine");
}

TEST_F(ReportEntries, ConfigureKeepsThePortsOfAReportedComponent) {
    ASSERT_TRUE(reporter->reportComponent("Machine"));
    const RTT::base::PortInterface* const port = reporter->getPort("Machine_speed");
    const LogText log;
    ASSERT_TRUE(reporter->configure());
    EXPECT_EQ("", log());
    EXPECT_EQ(port, reporter->getPort("Machine_speed"));
    RTT::OutputPort<int> late("late");
    machine.addPort(late);
    ASSERT_TRUE(reporter->configure());
    EXPECT_THAT(header(), testing::EndsWith(" Machine.mode Machine.late"));
}

TEST_F(ReportEntries, PortsWhoseNamesWouldBeTheSameAreBothReported) {
    const LogText log;
    RTT::TaskContext one("a"), other("a_b");
    RTT::OutputPort<int> first("b_c"), second("c");
    one.addPort(first);
    other.addPort(second);
    reporter->addPeer(&one);
    reporter->addPeer(&other);
    ASSERT_TRUE(reporter->reportPort("a", "b_c"));
    ASSERT_TRUE(reporter->reportPort("a_b", "c"));
    first.write(1);
    second.write(2);
    EXPECT_EQ("", log());
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp a.b_c a_b.c\n 0 1 2 \n", report());
    EXPECT_TRUE(reporter->unreportPort("a", "b_c"));
    EXPECT_FALSE(first.connected());
    EXPECT_TRUE(second.connected());
    reporter->cleanup();
}

TEST_F(ReportEntries, ConfigureRefusesAPortWhoseComponentHasGone) {
    const LogText log;
    auto other = std::make_unique<Machine>();
    reporter->removePeer("Machine");
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    other.reset();
    EXPECT_FALSE(reporter->configure());
    EXPECT_THAT(log(), HasSubstr("could not report component 'Machine': no such peer"));
}

TEST_F(ReportEntries, CleanupForgetsEverything) {
    ASSERT_TRUE(reporter->reportComponent("Machine"));
    ASSERT_TRUE(reporter->cleanup());
    EXPECT_EQ("", entries());
    EXPECT_TRUE(reporter->ports()->getPorts().empty());
    EXPECT_FALSE(machine.speed.connected());
}

TEST_F(ReportEntries, WhatIsUnreportedWhileRunningKeepsItsColumnUntilTheNextStart) {
    machine.speed.write(1);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    EXPECT_TRUE(reporter->unreportPort("Machine", "speed"));
    machine.speed.write(2);
    cycle();
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 1 \n 0.5 1 \n", report());
}

TEST_F(ReportEntries, ValuesAreLookedForAgainAtEachStart) {
    const LogText log;
    auto other = std::make_unique<RTT::TaskContext>("Other");
    double gone = 1, kept = 2;
    other->addProperty("gone", gone);
    other->addProperty("kept", kept);
    reporter->addPeer(other.get());
    for (const char* name : {"gone", "kept"}) ASSERT_TRUE(reporter->reportData("Other", name));
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    // Removed, and another one of that name added.
    other.reset(new RTT::TaskContext("Other"));
    std::string anotherType = "three";
    other->addProperty("kept", anotherType);
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->start());
    other->properties()->removeProperty(other->getProperty("kept"));
    EXPECT_EQ(" TimeStamp Other.kept Machine.gain\n 0 three 1.5 \n", report());
    EXPECT_THAT(log(), HasSubstr("'Reporter' leaves out 'Other.gone': no such peer, or it has no such property"));
    other.reset();
    text.str("");
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Machine.gain\n 0 1.5 \n", report());
    // Back again, in its old place.
    other.reset(new RTT::TaskContext("Other"));
    other->addProperty("gone", gone);
    reporter->addPeer(other.get());
    text.str("");
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Other.gone Machine.gain\n 0 1 1.5 \n", report());
}

TEST_F(ReportEntries, ValuesOfAPeerThatIsBeingDestroyedAreNotRead) {
    auto other = std::make_unique<RTT::TaskContext>("Other");
    double level = 1;
    other->addAttribute("level", level);
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->reportData("Other", "level"));
    ASSERT_TRUE(reporter->start());
    level = 2;
    cycle();
    std::thread([&other] { (void)other->stopForGood(); }).join();
    level = 3;  // what a destructor leaves
    cycle();
    other.reset();
    cycle();
    EXPECT_EQ(" TimeStamp Other.level\n 0 1 \n 0.5 2 \n 1 2 \n 1.5 2 \n", report());
}

TEST_F(ReportEntries, ReportPolicyDecidesHowPortsAreConnected) {
    property<RTT::ConnPolicy>("ReportPolicy") = RTT::ConnPolicy::buffer(10);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    for (int i = 1; i <= 3; ++i) machine.speed.write(i);
    for (int i = 0; i < 3; ++i) cycle(1);
    EXPECT_THAT(report(), HasSubstr(" 1 1 \n 2 2 \n 3 3 \n"));
}

TEST_F(ReportEntries, ScreenShowsTheInterfaceOfAPeer) {
    RTT::OutputPort<double> wire("wire");
    ASSERT_TRUE(wire.connectTo(&machine.setpoint));
    ASSERT_TRUE(reporter->screenComponent("Machine"));
    const std::string screen = text.str();
    EXPECT_EQ(0u, screen.find("Screening Component 'Machine' : \n\nProperties :\n  gain : 1.5\n"));
    EXPECT_THAT(screen, HasSubstr("Attributes :\n"));
    EXPECT_THAT(screen, HasSubstr("  label : blue\n"));
    EXPECT_THAT(screen, HasSubstr("Ports :\n  speed : (not connected)\n"));
    EXPECT_THAT(screen, HasSubstr("  setpoint : (connected)\n"));
    EXPECT_FALSE(reporter->screenComponent("Machin"));
}

TEST_F(ReportEntries, BaseClassNeedsSomebodyWhoWrites) {
    const LogText log;
    OCL::ReportingComponent base("Base");
    base.addPeer(&machine);
    ASSERT_TRUE(base.reportPort("Machine", "speed"));
    EXPECT_FALSE(base.start());
    EXPECT_THAT(log(), HasSubstr("needs at least one marshaller"));
    EXPECT_FALSE(base.screenComponent("Machine"));
    EXPECT_THAT(log(), HasSubstr("has no screenComponent() of its own"));
}

}  // namespace
