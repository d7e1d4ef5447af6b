// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component, its life cycle and its peers, in the words of those who write components.
#include <rtt/TaskContext.hpp>
#include <rtt/Port.hpp>
#include <rtt/Component.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#include <gtest/gtest.h>

using namespace std;
using namespace RTT;
using namespace RTT::types;
using namespace RTT::os;
using namespace RTT::extras;

namespace arm {

class Controller : public RTT::TaskContext {
    InputPort<vector<double>> inport_positions;
    RTT::OutputPort<vector<double>> outport_efforts;
    Attribute<int> cycles;
    Constant<string> version;
    double gain;
    vector<double> limits;
    string frame;

public:
    string calls;
    bool broken;

    Controller(string const& name)
        : TaskContext(name, PreOperational),
          inport_positions("positions"),
          outport_efforts("efforts", false),
          cycles("cycles", 0),
          version("version", "1.0"),
          gain(2.0),
          limits(2, 10.0),
          frame("base"),
          broken(false) {
        this->addPort(inport_positions).doc("Measured positions.");
        this->ports()->addPort("commands", outport_efforts).doc("Commanded efforts.");
        this->addProperty("gain", gain).doc("Gain of the controller.");
        this->addProperty("limits", limits);
        this->properties()->addProperty("frame", frame);
        this->addAttribute(cycles);
        this->addAttribute("broken", broken);
        this->addConstant(version);
        this->addConstant("joints", joints);
        this->addOperation("setGain", &Controller::setGain, this, RTT::OwnThread)
            .doc("Sets the gain.")
            .arg("value", "The new gain.");
        this->provides("diagnostics")->doc("About itself.");
        this->provides("diagnostics")->addOperation("cycles", &Controller::getCycles, this, ClientThread);
        this->provides("diagnostics")->addAttribute("frame", frame);
        outport_efforts.setDataSample(limits);
    }
    bool configureHook() {
        calls += "configure ";
        return gain > 0;
    }
    bool startHook() {
        calls += "start ";
        return inport_positions.connected();
    }
    void updateHook() {
        vector<double> positions;
        if (broken) {
            this->error();
            return;
        }
        if (inport_positions.read(positions) == RTT::NoData) return;
        for (unsigned int i = 0; i < positions.size(); i++) positions[i] *= -gain;
        outport_efforts.write(positions);
        cycles.set(cycles.get() + 1);
    }
    void errorHook() {
        calls += "error ";
        if (!broken) recover();
    }
    void stopHook() { calls += "stop "; }
    void cleanupHook() { calls += "cleanup "; }
    bool setGain(double value) {
        gain = value;
        return true;
    }
    int getCycles() { return cycles.get(); }
    static const int joints = 2;
};
const int Controller::joints;

}  // namespace arm

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(arm::Controller)

TEST(UserCode, RunsAComponentThroughItsLife) {
    arm::Controller controller("controller");
    controller.setActivity(new SlaveActivity(0.5));
    OutputPort<vector<double>> measured("measured");
    InputPort<vector<double>> commanded("commanded");
    EXPECT_EQ(controller.getTaskState(), TaskContext::PreOperational);
    EXPECT_FALSE(controller.start());
    EXPECT_TRUE(controller.configure());
    EXPECT_TRUE(controller.isConfigured());
    EXPECT_EQ(controller.getTaskState(), base::TaskCore::Stopped);
    EXPECT_FALSE(controller.start()) << "nothing is connected";
    EXPECT_TRUE(controller.getPort("positions")->connectTo(&measured));
    EXPECT_TRUE(controller.ports()->getPort("commands")->connectTo(&commanded));
    EXPECT_TRUE(controller.start());
    EXPECT_TRUE(controller.isRunning() && controller.isActive());
    EXPECT_EQ(controller.getTaskState(), TaskContext::Running);
    EXPECT_EQ(controller.getTargetState(), TaskContext::Running);

    measured.write(vector<double>(2, 1.5));
    EXPECT_TRUE(controller.update());
    vector<double> efforts;
    EXPECT_EQ(commanded.read(efforts), RTT::NewData);
    ASSERT_EQ(efforts.size(), 2u);
    EXPECT_EQ(efforts[1], -3.0);

    controller.broken = true;
    EXPECT_TRUE(controller.update());
    EXPECT_TRUE(controller.inRunTimeError());
    controller.broken = false;
    EXPECT_TRUE(controller.update());
    EXPECT_FALSE(controller.inRunTimeError() || controller.inException() || controller.inFatalError());
    EXPECT_TRUE(controller.stop());
    EXPECT_TRUE(controller.cleanup());
    EXPECT_EQ(controller.calls, "configure start start error error stop cleanup ") << "in the same step, too";
    EXPECT_EQ(controller.getPeriod(), 0.5);
    EXPECT_FALSE(controller.setPeriod(-1.0));
    EXPECT_TRUE(controller.getActivity()->stop());
    EXPECT_FALSE(controller.isActive());
    EXPECT_TRUE(controller.activate());
    EXPECT_TRUE(controller.isActive());
}

TEST(UserCode, LooksAtAnotherComponent) {
    arm::Controller controller("controller");
    TaskContext task("task");
    EXPECT_TRUE(task.addPeer(&controller));
    EXPECT_TRUE(task.hasPeer("controller"));
    RTT::TaskContext* peer = task.getPeer("controller");
    ASSERT_TRUE(peer != NULL);
    EXPECT_EQ(peer->getName(), "controller");
    EXPECT_EQ(task.getPeerList().size(), 1u);
    EXPECT_TRUE(task.getPeer("nobody") == 0);

    Property<double> gain = peer->getProperty("gain");
    ASSERT_TRUE(gain.ready());
    EXPECT_EQ(gain.getDescription(), "Gain of the controller.");
    EXPECT_EQ(peer->properties()->getPropertyType<double>("gain")->get(), 2.0);
    EXPECT_EQ(peer->properties()->find("frame")->getType(), "string");
    EXPECT_EQ(peer->properties()->size(), 3u);

    OperationCaller<bool(double)> setGain = peer->getOperation("setGain");
    ASSERT_TRUE(setGain.ready());
    setGain.setCaller(task.engine());
    EXPECT_TRUE(setGain(4.0));
    EXPECT_EQ(gain.get(), 4.0);
    OperationCaller<int(void)> cycles(peer->provides("diagnostics")->getOperation("cycles"), task.engine());
    EXPECT_EQ(cycles(), 0);

    Attribute<int> count = peer->attributes()->getAttribute("cycles");
    ASSERT_TRUE(count.ready());
    count.set(5);
    EXPECT_EQ(cycles(), 5);
    EXPECT_TRUE(peer->provides()->hasAttribute("version"));
    Constant<int> joints = peer->provides()->getConstant("joints");
    EXPECT_EQ(joints.get(), 2);
    EXPECT_EQ(peer->provides()->getPortNames().size(), 2u);
    EXPECT_TRUE(peer->provides()->hasService("diagnostics"));
    EXPECT_EQ(peer->provides()->getProviderNames().size(), 3u) << "the services of the ports, too";
    EXPECT_EQ(peer->provides("diagnostics")->getOwner(), &controller);
    EXPECT_EQ(peer->provides("diagnostics")->getParent(), peer->provides());
    EXPECT_TRUE(peer->operations()->hasMember("setGain"));
    task.removePeer("controller");
    EXPECT_FALSE(task.hasPeer("controller"));
}

TEST(UserCode, ConnectsComponents) {
    TaskContext left("left"), right("right");
    OutputPort<double> out("data");
    InputPort<double> in("data");
    left.addPort(out);
    right.addPort(in);
    EXPECT_TRUE(left.connectPeers(&right));
    EXPECT_TRUE(right.hasPeer("left"));
    EXPECT_TRUE(left.connectPorts(&right));
    EXPECT_TRUE(in.connected());
    EXPECT_EQ(out.getInterface()->getOwner()->getName(), "left");
    EXPECT_EQ(left.ports()->getPorts().size(), 1u);
    EXPECT_EQ(left.provides()->getService("data")->getName(), "data");
    in.disconnect();
    EXPECT_FALSE(out.connected());
    left.ports()->removePort("data");
    EXPECT_TRUE(left.getPort("data") == 0);
    left.provides()->clear();
}

TEST(UserCode, ListsItsComponentsInTheProgram) {
    RTT::FactoryMap& types = RTT::ComponentFactories::Instance();
    ASSERT_EQ(types.count("arm::Controller"), 1u);
    boost::shared_ptr<TaskContext> made(types["arm::Controller"]("made"));
    EXPECT_EQ(made->getName(), "made");
}
