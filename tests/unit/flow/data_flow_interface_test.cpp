// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Adding and removing ports: names, services, callbacks, and who is left behind.
#include "log_capture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Port.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include <memory>
#include <string>
#include <vector>

using namespace RTT;

namespace {

typedef std::vector<std::string> Names;

/** Its steps are made by calling update(). */
struct Component : TaskContext {
    explicit Component(const std::string& name = "component") : TaskContext(name) {
        setActivity(new extras::SlaveActivity());
    }
    ~Component() override { stop(); }
    void updateHook() override { ++updates; }
    /** A callback that counts. */
    DataFlowInterface::SlotFunction counting() {
        return [this](base::PortInterface*) { ++calls; };
    }
    int updates = 0, calls = 0;
};

struct Adding : testing::Test {
    flow_test::LogCapture log;
    OutputPort<int> out{"out"};
    InputPort<int> in{"in"}, other{"other"};
    std::unique_ptr<Component> owned{new Component};
    Component& c = *owned;
};

}  // namespace

TEST_F(Adding, GivesThePortBackForItsDescription) {
    EXPECT_EQ(&c.addPort("renamed", out).doc("text"), &out);
    EXPECT_EQ(&c.addEventPort("event", in), &in);
    EXPECT_EQ(&c.ports()->addLocalPort(other), &other);
    EXPECT_EQ(out.getName(), "renamed");
    EXPECT_EQ(c.ports()->getPortDescription("renamed"), "text");
    EXPECT_EQ(c.ports()->getPortNames(), (Names{"renamed", "event", "other"})) << "in the order of adding";
    EXPECT_EQ(c.ports()->getPorts().front(), &out);
    EXPECT_EQ(c.ports()->getOwner(), &c);
    EXPECT_EQ(c.ports()->getService(), c.provides().get());
    EXPECT_TRUE(c.ports()->setPortDescription("event", "another"));
    EXPECT_EQ(in.getDescription(), "another");
    EXPECT_EQ(c.provides("event")->doc(), "another");
    EXPECT_FALSE(c.ports()->setPortDescription("none", "text"));
    EXPECT_EQ(c.ports()->getPortDescription("none"), "");
    EXPECT_EQ(log.text(), "");
}

TEST_F(Adding, AConnectedPortKeepsItsName) {
    ASSERT_TRUE(out.connectTo(&in));
    c.addPort("renamed", in);
    EXPECT_EQ(in.getName(), "in");
    EXPECT_EQ(c.getPort("in"), &in);
    EXPECT_EQ(c.getPort("renamed"), nullptr);
}

TEST_F(Adding, ReplacesAServiceOfTheName) {
    const Service::shared_ptr before = c.provides("in");
    c.addPort(in);
    EXPECT_TRUE(log.contains("'in'")) << log.text();
    ASSERT_TRUE(c.provides()->hasService("in"));
    EXPECT_NE(c.provides("in"), before);
    EXPECT_TRUE(c.provides("in")->hasOperation("read"));
    EXPECT_EQ(before->getOwner(), nullptr);
}

TEST_F(Adding, AgainUnderAnotherNameLeavesNothingBehind) {
    c.addPort("first", in);
    c.addPort("second", in);
    EXPECT_EQ(c.ports()->getPortNames(), Names{"second"});
    EXPECT_EQ(c.provides()->getProviderNames(), Names{"second"});
}

TEST_F(Adding, AsEventPortLaterMakesItOne) {
    c.addPort(in);
    c.addEventPort(in, c.counting());
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(c.start());
    out.write(1);
    c.update();
    EXPECT_EQ(c.calls, 1);
    EXPECT_EQ(c.ports()->getPortNames(), Names{"in"});
    c.addPort(in);
    ASSERT_TRUE(out.connectTo(&in)) << "replacing has disconnected it";
    out.write(2);
    c.update();
    EXPECT_EQ(c.calls, 1) << "and back";
}

TEST_F(Adding, ToAnotherComponentTakesThePortAway) {
    Component next("next");
    c.addEventPort(in, c.counting());
    next.addEventPort(in, next.counting());
    EXPECT_EQ(c.getPort("in"), nullptr);
    EXPECT_FALSE(c.provides()->hasService("in"));
    EXPECT_EQ(in.getFullName(), "next.in");
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(c.start() && next.start());
    out.write(1);
    c.update();
    next.update();
    EXPECT_EQ(c.calls, 0);
    EXPECT_EQ(next.calls, 1);
}

TEST_F(Adding, LocalPortsHaveNoService) {
    c.ports()->addLocalPort(in);
    EXPECT_TRUE(c.provides()->getProviderNames().empty());
    c.ports()->addLocalEventPort(other, c.counting());
    EXPECT_TRUE(c.provides()->getProviderNames().empty());
    EXPECT_EQ(other.getFullName(), "component.other");
    ASSERT_TRUE(out.connectTo(&other));
    ASSERT_TRUE(c.start());
    out.write(1);
    c.update();
    EXPECT_EQ(c.calls, 1);
    c.ports()->removeLocalPort("other");
    EXPECT_FALSE(other.connected());
    EXPECT_EQ(c.ports()->getPortNames(), Names{"in"});
}

TEST_F(Adding, LocalPortsLeaveTheServiceOfTheirNameAlone) {
    const Service::shared_ptr service = c.provides("in");
    c.ports()->addLocalPort(in);
    EXPECT_EQ(c.provides("in"), service);
    c.ports()->removeLocalPort("in");
    EXPECT_TRUE(c.provides()->hasService("in"));
    c.addPort(other);
    c.provides()->removeService("other");
    const Service::shared_ptr own = c.provides("other");
    c.ports()->removePort("other");
    EXPECT_EQ(c.provides()->getService("other"), own);
}

TEST_F(Adding, RemovedPortsAreDisconnectedAndForgotten) {
    c.addEventPort(in, c.counting());
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(c.start());
    c.ports()->removePort("in");
    EXPECT_FALSE(out.connected());
    EXPECT_EQ(in.getInterface(), nullptr);
    EXPECT_FALSE(c.provides()->hasService("in"));
    ASSERT_TRUE(out.connectTo(&in));
    out.write(1);
    c.update();
    EXPECT_EQ(c.calls, 0);
}

TEST_F(Adding, RemovedPortThatWasRenamedTakesItsServiceAlong) {
    c.addPort(in);
    ASSERT_TRUE(in.setName("renamed"));
    c.ports()->removePort("renamed");
    EXPECT_TRUE(c.provides()->getProviderNames().empty());
}

TEST_F(Adding, ClearRemovesAllPortsAndTheirServices) {
    c.addPort(in);
    c.addPort(out);
    c.provides("kept");
    ASSERT_TRUE(out.connectTo(&in));
    c.ports()->clear();
    EXPECT_TRUE(c.ports()->getPorts().empty());
    EXPECT_EQ(c.provides()->getProviderNames(), Names{"kept"});
    EXPECT_EQ(in.getInterface(), nullptr);
    EXPECT_TRUE(in.connected()) << "that is the ports' business";
}

// --- event ports ---

TEST_F(Adding, EventPortsOutsideOfComponentsAreReported) {
    Service alone("alone");
    alone.addEventPort(in);
    EXPECT_TRUE(log.contains("alone.in")) << log.text();
    EXPECT_EQ(alone.getPort("in"), &in);
    EXPECT_TRUE(alone.hasService("in"));
    DataFlowInterface bare;
    bare.addEventPort(other);
    EXPECT_TRUE(log.contains("port other")) << log.text();
    EXPECT_EQ(bare.getPort("other"), &other);
    ASSERT_TRUE(out.connectTo(&in) && out.connectTo(&other));
    EXPECT_EQ(out.write(1), WriteSuccess);
}

TEST_F(Adding, EventPortsOfServicesWakeTheComponent) {
    c.provides("sub")->addEventPort(in, c.counting());
    c.provides("sub")->provides("deeper")->addEventPort(other);
    ASSERT_TRUE(out.connectTo(&in) && out.connectTo(&other));
    ASSERT_TRUE(c.start());
    out.write(1);
    EXPECT_TRUE(c.engine()->hasWork());
    c.update();
    EXPECT_EQ(c.calls, 1);
    EXPECT_EQ(c.updates, 1);
    EXPECT_EQ(log.text(), "");
}

TEST_F(Adding, EventPortsOfARemovedServiceWakeNobody) {
    const Service::shared_ptr sub = c.provides("sub");
    sub->provides("deeper")->addEventPort(in, c.counting());
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(c.start());
    c.provides()->removeService("sub");
    out.write(1);
    c.update();
    EXPECT_EQ(c.calls, 0);
    EXPECT_EQ(in.getFullName(), "sub.deeper.in") << "it is still the service's";
    int got = 0;
    EXPECT_EQ(in.read(got), NewData);
    Component next("next");
    ASSERT_TRUE(next.provides()->addService(sub));
    ASSERT_TRUE(next.start());
    owned.reset();
    out.write(2);
    next.update();
    EXPECT_EQ(next.calls, 0);
}

// The engine knows the port until its callback is due.
TEST_F(Adding, PortOfARemovedServiceMayBeDestroyedThoughItsCallbackIsDue) {
    auto port = std::make_unique<InputPort<int>>("port");
    c.provides("sub")->addEventPort(*port, c.counting());
    ASSERT_TRUE(out.connectTo(port.get()));
    ASSERT_TRUE(c.start());
    out.write(1);
    ASSERT_TRUE(c.engine()->hasWork());
    c.provides()->removeService("sub");
    port.reset();
    c.update();
    EXPECT_EQ(c.calls, 0);
}

TEST_F(Adding, EventPortsOfAServiceThatMovesAreTakenFromItsFirstComponent) {
    Component next("next");
    const Service::shared_ptr sub = c.provides("sub");
    sub->addEventPort(in, c.counting());
    ASSERT_TRUE(next.provides()->addService(sub));
    EXPECT_EQ(sub->getOwner(), &next);
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(c.start() && next.start());
    out.write(1);
    EXPECT_FALSE(c.engine()->hasWork());
    c.update();
    EXPECT_EQ(c.calls, 0);
    sub->addEventPort(in, next.counting());
    ASSERT_TRUE(out.connectTo(&in));
    out.write(2);
    next.update();
    EXPECT_EQ(next.calls, 1) << "added again it is one of the new component";
}

TEST_F(Adding, EventPortOfAServiceClassGivenItsOwnerNeedNotBeAddedBefore) {
    struct Own : Service {
        explicit Own(Component& c) : Service("own", &c) { addEventPort("in", in, c.counting()); }
        InputPort<int> in;
    };
    const auto own = boost::make_shared<Own>(c);
    ASSERT_TRUE(c.provides()->addService(own));
    ASSERT_TRUE(out.connectTo(&own->in));
    ASSERT_TRUE(c.start());
    out.write(1);
    c.update();
    EXPECT_EQ(c.calls, 1);
    EXPECT_EQ(log.text(), "");
}

TEST_F(Adding, CallbackHookDecidesWhatIsDone) {
    struct Deciding : Component {
        bool dataOnPortHook(base::PortInterface* port) override {
            asked = port;
            return wanted;
        }
        void dataOnPortCallback(base::PortInterface* port) override {
            called = port;
            Component::dataOnPortCallback(port);
        }
        bool wanted = false;
        base::PortInterface *asked = nullptr, *called = nullptr;
    } deciding;
    deciding.addEventPort(in, deciding.counting());
    ASSERT_TRUE(out.connectTo(&in));
    out.write(1);
    EXPECT_EQ(deciding.asked, &in);
    deciding.update();
    EXPECT_EQ(deciding.called, nullptr);
    deciding.wanted = true;
    out.write(2);
    deciding.update();
    EXPECT_EQ(deciding.called, &in);
    EXPECT_EQ(deciding.calls, 1);
}
