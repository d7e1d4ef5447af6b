// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Two components that are connected as a whole: ports, services, peers; and what leaves with a component.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/internal/ConnectionManager.hpp>

#include <gmock/gmock.h>

using namespace RTT;
using oroforge::test::Probe;
using testing::ElementsAre;

namespace {

/** A component with members as interface. */
struct WithPorts : Probe {
    explicit WithPorts(const std::string& name) : Probe(name) { provides("sub")->addPort("nested", nested); }
    InputPort<int> in;
    OutputPort<int> out, other;
    OutputPort<double> wrong;
    InputPort<int> nested;
};

struct Connecting : testing::Test {
    WithPorts a{"a"}, b{"b"};
};

TEST_F(Connecting, PortsOfOppositeDirectionAreConnectedAndOthersAreSkipped) {
    a.addPort("forth", a.out);
    a.addPort("same", a.other);
    a.addPort("missing", a.wrong);
    b.addPort("forth", b.in);
    b.addPort("same", b.other);
    EXPECT_TRUE(a.connectPorts(&b));
    EXPECT_TRUE(a.out.connectedTo(&b.in));
    EXPECT_FALSE(a.other.connected() || b.other.connected() || a.wrong.connected());
}

TEST_F(Connecting, PortThatCannotBeConnectedIsAFailureButStopsNothing) {
    a.addPort("bad", a.wrong);
    a.addPort("good", a.out);
    b.addPort("bad", b.nested);
    b.addPort("good", b.in);
    EXPECT_FALSE(connectPorts(&a, &b)) << "double and int";
    EXPECT_TRUE(a.out.connectedTo(&b.in));
    EXPECT_FALSE(a.wrong.connected());
}

TEST_F(Connecting, PortsOfSubServicesAreNotConnected) {
    OutputPort<int> nestedOut;
    a.provides("sub")->addPort("nested", nestedOut);
    a.addPort("nested", a.out);
    EXPECT_TRUE(a.connectPorts(&b)) << "b has that port in a service only";
    EXPECT_FALSE(nestedOut.connected() || a.out.connected() || b.nested.connected());
}

TEST_F(Connecting, PortsGetTheDefaultPolicyOfTheReader) {
    InputPort<int> buffered("data", ConnPolicy::buffer(7));
    a.addPort("data", a.out);
    b.addPort(buffered);
    ASSERT_TRUE(a.connectPorts(&b));
    const auto channels = a.out.getManager()->getChannels();
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels.front().get<2>().type, ConnPolicy::BUFFER);
    EXPECT_EQ(channels.front().get<2>().size, 7);
}

TEST_F(Connecting, PeersAreRefusedIfEitherNameIsKnown) {
    ASSERT_TRUE(b.addPeer(&a));
    EXPECT_FALSE(a.connectPeers(&b)) << "b knows an a";
    EXPECT_FALSE(a.hasPeer("b"));
    b.removePeer(&a);
    ASSERT_TRUE(a.addPeer(&a, "b"));
    EXPECT_FALSE(connectPeers(&a, &b)) << "a knows somebody of that name";
    EXPECT_FALSE(b.hasPeer("a"));
    a.removePeer("b");
    EXPECT_TRUE(connectPeers(&a, &b));
}

TEST_F(Connecting, RemovingPeersThatAreNoneDoesNothing) {
    ASSERT_TRUE(a.addPeer(&b));
    a.removePeer(&a);
    a.removePeer(static_cast<TaskContext*>(nullptr));
    a.removePeer(std::string("nobody"));
    a.disconnectPeers("nobody");
    EXPECT_THAT(a.getPeerList(), ElementsAre("b"));
}

TEST_F(Connecting, RemovingAPeerTakesAllItsNames) {
    ASSERT_TRUE(a.addPeer(&b) && a.addPeer(&b, "zulu") && a.addPeer(&b, "alpha"));
    EXPECT_THAT(a.getPeerList(), ElementsAre("alpha", "b", "zulu")) << "in alphabetical order";
    a.removePeer(&b);
    EXPECT_TRUE(a.getPeerList().empty());
}

TEST_F(Connecting, DisconnectTakesPortsPeersAndUsersAway) {
    a.addPort("forth", a.out);
    b.addPort("forth", b.in);
    OutputPort<int> toNested("out");
    ASSERT_TRUE(a.connectPorts(&b) && toNested.connectTo(&a.nested));
    ASSERT_TRUE(a.addPeer(&b) && b.addPeer(&a, "alias"));
    a.disconnect();
    EXPECT_FALSE(a.out.connected() || b.in.connected());
    EXPECT_FALSE(a.nested.connected()) << "the ports of its services too";
    EXPECT_TRUE(a.getPeerList().empty() && b.getPeerList().empty());
    EXPECT_EQ(a.getPort("forth"), &a.out) << "the interface stays";
}

TEST(Leaving, ADestroyedComponentIsNobodysUser) {
    Probe b("b");
    {
        Probe a("a");
        ASSERT_TRUE(a.addPeer(&b));
    }
    b.disconnect();  // would tell a
    EXPECT_TRUE(b.getPeerList().empty());
}

// --- services ---

struct ConnectingServices : testing::Test {
    Probe server{"server"}, client{"client"};
    OperationCaller<int()> number{"number"}, other{"number"};

    static void offer(const Service::shared_ptr& service, int n) {
        service->addOperation("number", [n] { return n; });
    }
};

TEST_F(ConnectingServices, RootsAreConnectedFirstAndInBothDirections) {
    offer(server.provides(), 1);
    client.requires_()->addOperationCaller(number);
    OperationCaller<int()> back("back");
    server.requires_()->addOperationCaller(back);
    client.addOperation("back", [] { return 2; });
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_EQ(number(), 1);
    EXPECT_EQ(back(), 2);
    EXPECT_EQ(client.requires_()->getReferencedService(), server.provides());
    EXPECT_EQ(server.requires_()->getReferencedService(), client.provides());
}

TEST_F(ConnectingServices, RootsThatRequireNothingKnowTheirServiceToo) {
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_EQ(client.requires_()->getReferencedService(), server.provides());
    EXPECT_EQ(server.requires_()->getReferencedService(), client.provides());
}

TEST_F(ConnectingServices, RootsThatLackAnOperationAreNoFailure) {
    client.requires_()->addOperationCaller(number);
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_FALSE(number.ready());
}

TEST_F(ConnectingServices, RequestersThatAreReadyKeepTheirService) {
    Probe first("first");
    offer(first.provides("numbers"), 1);
    offer(server.provides("numbers"), 2);
    client.requires_("numbers")->addOperationCaller(number);
    ASSERT_TRUE(client.connectServices(&first));
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_EQ(number(), 1);
    EXPECT_EQ(client.requires_("numbers")->getReferencedService(), first.provides("numbers"));
}

TEST_F(ConnectingServices, OnlyTheFirstLevelIsConnected) {
    offer(server.provides("outer")->provides("inner"), 3);
    client.requires_("outer")->requires_("inner")->addOperationCaller(number);
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_FALSE(number.ready());
}

TEST_F(ConnectingServices, MissingServicesAreNotMade) {
    client.requires_("numbers")->addOperationCaller(number);
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_FALSE(server.provides()->hasService("numbers"));
    EXPECT_FALSE(client.connectServices(nullptr));
}

struct NumberRequester : ServiceRequester {
    explicit NumberRequester(TaskContext* owner) : ServiceRequester("numbers", owner) { addOperationCaller(number); }
    OperationCaller<int()> number{"number"};
};

TEST_F(ConnectingServices, ProviderIsMadeForAServiceThatTheComponentHas) {
    offer(server.provides("numbers"), 4);
    const auto numbers = server.getProvider<NumberRequester>("numbers");
    ASSERT_TRUE(numbers);
    EXPECT_EQ(numbers->number(), 4);
    EXPECT_EQ(numbers->getServiceOwner(), &server);
    EXPECT_EQ(numbers->getReferencedService(), server.provides("numbers"));
    EXPECT_EQ(server.getProvider<NumberRequester>("numbers"), numbers);
    EXPECT_FALSE(client.getProvider<NumberRequester>("numbers")) << "and no plugin brings it";
    EXPECT_FALSE(client.provides()->hasService("numbers"));
}

TEST_F(ConnectingServices, ProviderThatIsHeldLongerThanItsComponentLivesBelongsToNobody) {
    boost::shared_ptr<NumberRequester> numbers;
    ServiceRequester::shared_ptr root, sub;
    {
        Probe shortLived("short_lived");
        offer(shortLived.provides("numbers"), 4);
        numbers = shortLived.getProvider<NumberRequester>("numbers");
        root = shortLived.requires_();
        sub = shortLived.requires_("sub");
        ASSERT_TRUE(numbers->ready());
        ASSERT_EQ(sub->getServiceOwner(), &shortLived);
    }
    EXPECT_EQ(numbers->getServiceOwner(), nullptr);
    EXPECT_EQ(root->getServiceOwner(), nullptr);
    EXPECT_EQ(sub->getServiceOwner(), nullptr);
    EXPECT_FALSE(numbers->ready());
    server.provides("numbers")->addOperation(
        "number", [] { return 5; }, OwnThread);
    EXPECT_TRUE(numbers->connectTo(server.provides("numbers")));
    EXPECT_THROW(numbers->number(), SendError) << "there is no caller any more";
    numbers->number.setCaller(client.engine());
    EXPECT_EQ(numbers->number(), 5);
}

TEST(Clear, EmptiesServiceAndRequester) {
    Probe c("c");
    int variable = 1;
    InputPort<int> port("port");
    OperationCaller<int()> caller("caller");
    c.addPort(port);
    c.addAttribute("attribute", variable);
    c.addProperty("property", variable);
    c.provides("sub");
    c.requires_()->addOperationCaller(caller);
    c.requires_("other");
    c.clear();
    EXPECT_TRUE(c.operations()->getNames().empty());
    EXPECT_TRUE(c.ports()->getPorts().empty());
    EXPECT_EQ(port.getInterface(), nullptr);
    EXPECT_TRUE(c.attributes()->getAttributeNames().empty());
    EXPECT_EQ(c.properties()->size(), 0u);
    EXPECT_TRUE(c.provides()->getProviderNames().empty());
    EXPECT_TRUE(c.requires_()->getOperationCallerNames().empty());
    EXPECT_TRUE(c.requires_()->getRequesterNames().empty());
    EXPECT_EQ(c.getName(), "c");
    EXPECT_TRUE(c.start()) << "it is still a component";
}

}  // namespace
