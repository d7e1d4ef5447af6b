// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component as others see it: standard interface, peers, activity, ports, services of plugins.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/plugin_loading.hpp>

#include <gmock/gmock.h>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;
using testing::ElementsAre;

namespace {

TEST(StandardInterface, OperationsHaveTheirSignatures) {
    Probe c;
    const auto ready = [&](auto caller) { return caller.ready(); };
    for (const char* name : {"configure", "isConfigured", "start", "activate", "stop", "isRunning", "isActive",
                             "inFatalError", "inRunTimeError", "inException", "cleanup", "update", "trigger"})
        EXPECT_TRUE(ready(OperationCaller<bool()>(c.getOperation(name)))) << name;
    EXPECT_TRUE(ready(OperationCaller<double()>(c.getOperation("getPeriod"))));
    EXPECT_TRUE(ready(OperationCaller<bool(double)>(c.getOperation("setPeriod"))));
    EXPECT_TRUE(ready(OperationCaller<unsigned()>(c.getOperation("getCpuAffinity"))));
    EXPECT_TRUE(ready(OperationCaller<bool(unsigned)>(c.getOperation("setCpuAffinity"))));
    EXPECT_TRUE(ready(OperationCaller<void()>(c.getOperation("error"))));
    EXPECT_EQ(c.operations()->getArity("loadService"), 1);
    EXPECT_EQ(c.operations()->getNames().size(), 19u);
    for (const char* name : {"recover", "fatal", "exception", "resetException"})
        EXPECT_FALSE(c.operations()->hasMember(name)) << name;
}

TEST(StandardInterface, OperationsChangeTheState) {
    Probe c("c", TaskContext::PreOperational);
    EXPECT_TRUE(OperationCaller<bool()>(c.getOperation("configure"))());
    EXPECT_TRUE(OperationCaller<bool()>(c.getOperation("start"))());
    EXPECT_TRUE(OperationCaller<bool()>(c.getOperation("isRunning"))());
    EXPECT_TRUE(OperationCaller<bool()>(c.getOperation("stop"))());
    EXPECT_EQ(c.takeHooks(), "configure start stop");
}

TEST(StandardInterface, AttributesAndServiceText) {
    Probe c;
    EXPECT_THAT(c.attributes()->getAttributeNames(),
                ElementsAre("TriggerOnStart", "CycleCounter", "IOCounter", "TimeOutCounter", "TriggerCounter"));
    EXPECT_EQ(c.provides()->doc(), "The interface of this TaskContext.");
    EXPECT_EQ(c.provides()->getName(), "probe");
    EXPECT_EQ(c.provides()->getOwner(), &c);
    EXPECT_TRUE(c.ready());
}

TEST(Peers, AreKnownByNameOrAlias) {
    Probe a("a"), b("b"), c("c");
    EXPECT_TRUE(a.addPeer(&b));
    EXPECT_FALSE(a.addPeer(&b)) << "the name is taken";
    EXPECT_TRUE(a.addPeer(&b, "other"));
    EXPECT_FALSE(a.addPeer(&c, "other"));
    EXPECT_FALSE(a.addPeer(nullptr));
    EXPECT_THAT(a.getPeerList(), ElementsAre("b", "other"));
    EXPECT_EQ(a.getPeer("other"), &b);
    EXPECT_EQ(a.getPeer("c"), nullptr);
    EXPECT_FALSE(b.hasPeer("a")) << "one direction";
    a.removePeer("nobody");
    a.removePeer("other");
    EXPECT_TRUE(a.hasPeer("b"));
    a.removePeer(&b);
    EXPECT_FALSE(a.hasPeer("b"));
}

TEST(Peers, AreConnectedAndDisconnectedInBothDirections) {
    Probe a("a"), b("b");
    EXPECT_TRUE(connectPeers(&a, &b));
    EXPECT_FALSE(connectPeers(&a, &b));
    EXPECT_TRUE(a.hasPeer("b") && b.hasPeer("a"));
    a.disconnectPeers("b");
    EXPECT_FALSE(a.hasPeer("b") || b.hasPeer("a"));
    EXPECT_FALSE(a.connectPeers(nullptr));
}

TEST(Peers, LeaveWhenDestroyed) {
    Probe a("a");
    {
        Probe b("b");
        connectPeers(&a, &b);
        a.addPeer(&b, "alias");
    }
    EXPECT_TRUE(a.getPeerList().empty());
}

TEST(Peers, DisconnectLeavesEverybody) {
    Probe a("a"), b("b"), c("c");
    connectPeers(&a, &b);
    c.addPeer(&a);
    a.disconnect();
    EXPECT_TRUE(a.getPeerList().empty());
    EXPECT_FALSE(b.hasPeer("a"));
    EXPECT_FALSE(c.hasPeer("a"));
}

TEST(SetActivity, ReplacesAndStartsIt) {
    Probe c;
    auto* slave = new extras::SlaveActivity(0.5);
    EXPECT_TRUE(c.setActivity(slave));
    EXPECT_EQ(c.getActivity(), slave);
    EXPECT_EQ(c.getActivity<extras::SlaveActivity>(), slave);
    EXPECT_EQ(c.getActivity<Activity>(), nullptr);
    EXPECT_TRUE(c.isActive());
    EXPECT_EQ(c.getPeriod(), 0.5);
    EXPECT_TRUE(c.setActivity(nullptr)) << "a default one";
    EXPECT_TRUE(c.getActivity<Activity>());
    EXPECT_TRUE(c.isActive());
}

TEST(SetActivity, IsRefusedWhileRunningAndInTheOwnThread) {
    Probe c;
    base::ActivityInterface* const before = c.getActivity();
    ASSERT_TRUE(c.start());
    EXPECT_FALSE(c.setActivity(new extras::SlaveActivity()));
    ASSERT_TRUE(c.stop());
    std::atomic<int> result{-1};
    c.addOperation(
        "change", [&] { result = c.setActivity(new extras::SlaveActivity()); }, OwnThread);
    OperationCaller<void()>(c.getOperation("change")).send();
    ASSERT_TRUE(eventually([&] { return result != -1; }));
    EXPECT_EQ(result, 0);
    EXPECT_EQ(c.getActivity(), before);
}

TEST(SetActivity, OfASequentialComponentCanBeChangedFromMain) {
    Probe c;
    ASSERT_TRUE(c.setActivity(new extras::SequentialActivity()));
    EXPECT_TRUE(c.setActivity(new Activity(0, 0.1)));
    EXPECT_EQ(c.getPeriod(), 0.1);
}

TEST(Update, IsForActivitiesThatLeaveItToOthers) {
    Probe c;
    EXPECT_FALSE(c.update());
    ASSERT_TRUE(c.setActivity(new extras::SlaveActivity()));
    ASSERT_TRUE(c.start());
    EXPECT_TRUE(c.update());
    EXPECT_GE(c.updates, 1);
}

TEST(ConnectPorts, ConnectsEquallyNamedPortsOfOppositeDirection) {
    struct WithPorts : Probe {
        using Probe::Probe;
        InputPort<int> in;
        OutputPort<int> out;
        InputPort<double> same;
        ~WithPorts() override { ports()->clear(); }
    };
    WithPorts a("a"), b("b");
    a.addPort("forth", a.out);
    a.addPort("back", a.in);
    a.addPort("same", a.same);
    b.addPort("forth", b.in);
    b.addPort("back", b.out);
    b.addPort("same", b.same);
    EXPECT_TRUE(connectPorts(&a, &b));
    EXPECT_TRUE(a.out.connectedTo(&b.in));
    EXPECT_TRUE(a.in.connectedTo(&b.out));
    EXPECT_FALSE(a.same.connected());
    EXPECT_FALSE(a.connectPorts(nullptr));
}

// --- services that plugins bring ---

struct Adder : Service {
    explicit Adder(TaskContext* owner) : Service("adder", owner) {
        addOperation("add", [](int a, int b) { return a + b; });
    }
};
struct AdderRequester : ServiceRequester {
    explicit AdderRequester(TaskContext* owner) : ServiceRequester("adder", owner) { addOperationCaller(add); }
    OperationCaller<int(int, int)> add{"add"};
};

int loads = 0;
bool fakeLoader(const std::string& service, TaskContext* component) {
    ++loads;
    if (service != "adder") return false;
    const auto into = component ? component->provides() : internal::GlobalService::Instance();
    return into->addService(Service::shared_ptr(new Adder(component)));
}

struct LoadedServices : testing::Test {
    LoadedServices() {
        loads = 0;
        internal::setPluginLoader(&fakeLoader, nullptr);
    }
    ~LoadedServices() override { internal::setPluginLoader(nullptr, nullptr); }
};

TEST_F(LoadedServices, AreLoadedOnce) {
    Probe c;
    EXPECT_TRUE(c.loadService("adder"));
    EXPECT_TRUE(c.loadService("adder"));
    EXPECT_EQ(loads, 1);
    EXPECT_FALSE(c.loadService("unknown"));
    EXPECT_EQ(c.provides("adder")->getOwner(), &c);
}

TEST_F(LoadedServices, GetProviderGivesAConnectedRequester) {
    Probe c;
    boost::shared_ptr<AdderRequester> adder = c.getProvider<AdderRequester>("adder");
    ASSERT_TRUE(adder);
    EXPECT_TRUE(adder->ready());
    EXPECT_EQ(adder->add(2, 3), 5);
    EXPECT_EQ(c.getProvider<AdderRequester>("adder"), adder) << "the same again";
    EXPECT_FALSE(c.getProvider<AdderRequester>("unknown"));
    struct Other : ServiceRequester {
        explicit Other(TaskContext* owner) : ServiceRequester("adder", owner) {}
    };
    EXPECT_FALSE(c.getProvider<Other>("adder")) << "is there as another class";
    EXPECT_TRUE(c.getProvider<Adder>("adder")) << "the service itself";
}

TEST_F(LoadedServices, GlobalServiceRequiresThem) {
    const auto global = internal::GlobalService::Instance();
    EXPECT_EQ(global->getName(), "GlobalService");
    OperationCaller<bool(const std::string&)> require = global->getOperation("require");
    EXPECT_TRUE(require("adder"));
    EXPECT_TRUE(global->hasService("adder"));
    EXPECT_FALSE(require("unknown"));
    global->removeService("adder");
}

TEST(LoadService, WithoutLoaderFails) {
    Probe c;
    EXPECT_FALSE(c.loadService("adder"));
}

}  // namespace
