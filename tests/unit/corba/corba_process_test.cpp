// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component of another process, used by its proxy.
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>

#include "peer_fixture.hpp"

#include <string>
#include <thread>
#include <vector>

using namespace RTT;
using corba_test::soon;

namespace {

class CorbaProcesses : public corba_test::PeerFixture {};

}  // namespace

TEST_F(CorbaProcesses, AProxyHasTheInterface) {
    EXPECT_EQ(peer->getName(), "peer");
    EXPECT_TRUE(peer->ready());
    for (const char* const name : {"add", "own", "change", "start", "loadService"})
        EXPECT_TRUE(peer->provides()->hasOperation(name)) << name;
    EXPECT_TRUE(peer->provides()->hasService("sub"));
    EXPECT_TRUE(peer->provides("sub")->hasService("deep"));
    EXPECT_TRUE(peer->provides()->hasService("other"));
    const auto described = peer->getOperation("add")->getArgumentList();
    ASSERT_EQ(described.size(), 2U);
    EXPECT_EQ(described[1].name, "b");
    EXPECT_EQ(described[1].description, "The second.");
    EXPECT_EQ(peer->getOperation("change")->getArgumentList()[0].type, "double &");
    EXPECT_EQ(peer->getPort("in")->getDescription(), "Samples come back from here.");
    EXPECT_FALSE(peer->getPort("in")->isLocal());
    EXPECT_EQ(peer->getPeerList(), TaskContext::PeerList{"friendly"});
    TaskContext* const friendly = peer->getPeer("friendly");
    ASSERT_TRUE(friendly);
    EXPECT_EQ(friendly->getName(), "friendly");
    delete friendly;
}

TEST_F(CorbaProcesses, PropertiesAndAttributesAreThoseOfTheOther) {
    Property<double> gain(peer->getProperty("gain"));
    ASSERT_TRUE(gain.ready());
    EXPECT_EQ(gain.get(), 1.5);
    gain.set(4);
    EXPECT_EQ(Property<double>(peer->getProperty("gain")).get(), 4);
    EXPECT_EQ(peer->getProperty("label")->getDataSource()->toString(), "first");
    Property<PropertyBag> settings(peer->getProperty("settings"));
    ASSERT_TRUE(settings.ready());
    Property<double> limit(settings.value().find("limit"));
    ASSERT_TRUE(limit.ready());
    EXPECT_EQ(limit.get(), 7);
    limit.set(8);
    EXPECT_EQ(limit.get(), 8);
    Attribute<double> level(peer->getAttribute("level"));
    ASSERT_TRUE(level.ready());
    EXPECT_EQ(level.get(), 0.5);
    level.set(2);
    EXPECT_EQ(level.get(), 2);
    EXPECT_EQ(peer->getAttribute("pi")->getDataSource()->toString(), "3.5");
}

TEST_F(CorbaProcesses, OperationsAreCalledAndSent) {
    OperationCaller<int(int, int)> add(peer->getOperation("add"));
    ASSERT_TRUE(add.ready());
    EXPECT_EQ(add(2, 3), 5);
    OperationCaller<std::string(const std::string&)> own(peer->getOperation("own"));
    ASSERT_TRUE(own.ready());
    EXPECT_EQ(own("runs in"), "runs in own");
    OperationCaller<int(double&, std::string&)> change(peer->getOperation("change"));
    ASSERT_TRUE(change.ready());
    double number = 1.5;
    std::string text = "x";
    EXPECT_EQ(change(number, text), 5);
    EXPECT_EQ(number, 3);
    EXPECT_EQ(text, "x!");
    auto handle = change.send(number, text);
    int result = 0;
    EXPECT_EQ(handle.collect(result, number, text), SendSuccess);
    EXPECT_EQ(result, 5);
    EXPECT_EQ(number, 6);
    EXPECT_EQ(text, "x!!");
    OperationCaller<void()> nothing(peer->getOperation("nothing"));
    nothing();
    EXPECT_EQ(OperationCaller<int()>(peer->getOperation("count"))(), 1);
    EXPECT_EQ(OperationCaller<double(const std::vector<double>&)>(peer->getOperation("sum"))({1, 2, 3}), 6);
    EXPECT_EQ(OperationCaller<int(int)>(peer->provides("sub")->provides("deep")->getOperation("thrice"))(4), 12);
    try {
        OperationCaller<void()>(peer->getOperation("fail"))();
        FAIL() << "it throws";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("on purpose"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(peer->inException());
}

TEST_F(CorbaProcesses, WhatItRequiresIsProvidedFromHere) {
    struct Here : TaskContext {
        Here() : TaskContext("here") { provides("wish")->addOperation("wished", &Here::wished, this); }
        int wished(int value) { return value + 1; }
    } here;
    EXPECT_EQ(peer->requires_()->getRequesterNames(), ServiceRequester::RequesterNames{"wish"});
    EXPECT_EQ(peer->requires_("wish")->getOperationCallerNames(), ServiceRequester::OperationCallerNames{"wished"});
    EXPECT_FALSE(peer->requires_("wish")->ready());
    OperationCaller<int(int)> callWished(peer->getOperation("callWished"));
    EXPECT_EQ(callWished(3), -1);
    EXPECT_TRUE(here.connectServices(peer.get()));
    EXPECT_TRUE(peer->requires_("wish")->ready());
    EXPECT_EQ(callWished(3), 4);
    peer->requires_("wish")->disconnect();
    EXPECT_EQ(callWished(3), -1);
    corba::TaskContextServer::CleanupServer(&here);
}

TEST_F(CorbaProcesses, TheStateChangesThere) {
    EXPECT_EQ(peer->getTaskState(), TaskContext::PreOperational);
    EXPECT_FALSE(peer->start());
    EXPECT_TRUE(peer->configure());
    EXPECT_TRUE(peer->start());
    EXPECT_TRUE(peer->isRunning());
    EXPECT_TRUE(peer->stop());
    EXPECT_EQ(peer->getTaskState(), TaskContext::Stopped);
}

TEST_F(CorbaProcesses, SamplesCrossInBothDirections) {
    for (const bool pull : {ConnPolicy::PUSH, ConnPolicy::PULL}) {
        SCOPED_TRACE(pull);
        TaskContext here("here");
        OutputPort<double> out("out");
        InputPort<double> in("in");
        here.addPort(out);
        here.addPort(in);
        ASSERT_TRUE((peer->configure(), peer->isRunning() || peer->start()));
        ConnPolicy policy = ConnPolicy::buffer(10);
        policy.pull = pull;
        ASSERT_TRUE(out.connectTo(peer->getPort("echo"), policy));
        ASSERT_TRUE(peer->getPort("out")->connectTo(&in, policy));
        EXPECT_TRUE(peer->getPort("echo")->connected());
        double got = 0;
        for (int i = 1; i <= 200; ++i) {
            ASSERT_EQ(out.write(i), WriteSuccess);
            ASSERT_TRUE(soon([&] { return in.read(got) == NewData; })) << i;
            EXPECT_EQ(got, 2 * i);
        }
        out.disconnect();
        EXPECT_TRUE(soon([&] { return !peer->getPort("echo")->connected(); }));
        peer->getPort("out")->disconnect();
        EXPECT_TRUE(soon([&] { return !in.connected(); }));
    }
}

TEST_F(CorbaProcesses, ConnectionsThatBeginAtOnceKeepTheirNames) {
    TaskContext here("here");
    OutputPort<double> out("out");
    InputPort<double> in("in");
    here.addPort(out);
    here.addPort(in);
    ASSERT_TRUE(peer->configure() && peer->start());
    ASSERT_TRUE(out.connectTo(peer->getPort("echo"), ConnPolicy::buffer(10)));
    for (int i = 0; i != 40 && !HasFailure(); ++i) {
        ConnPolicy doubled = ConnPolicy::buffer(10), tripled = ConnPolicy::buffer(10);
        bool isDone = false;
        std::thread other([&] { isDone = peer->getPort("tripled")->connectTo(&in, tripled); });
        EXPECT_TRUE(peer->getPort("out")->connectTo(&in, doubled));
        other.join();
        EXPECT_TRUE(isDone);
        EXPECT_EQ(doubled.name_id, "");
        EXPECT_TRUE(peer->getPort("out")->disconnect(&in));
        EXPECT_TRUE(in.connected());
        EXPECT_TRUE(soon([&] { return !peer->getPort("out")->connected(); })) << "the other one was disconnected";
        EXPECT_TRUE(peer->getPort("tripled")->connected());
        EXPECT_TRUE(peer->getPort("tripled")->connectedTo(&in));
        EXPECT_TRUE(peer->getPort("tripled")->disconnect(&in));
        EXPECT_TRUE(soon([&] { return !peer->getPort("tripled")->connected(); }));
        EXPECT_FALSE(in.connected());
    }
}

TEST_F(CorbaProcesses, APeerThatIsKilledIsNoticed) {
    OutputPort<double> out("out");
    TaskContext here("here");
    here.addPort(out);
    ASSERT_TRUE(out.connectTo(peer->getPort("in"), ConnPolicy::buffer(10)));
    OperationCaller<int(int, int)> add(peer->getOperation("add"));
    end(SIGKILL);
    EXPECT_THROW(add(1, 2), std::runtime_error);
    EXPECT_FALSE(peer->ready());
    EXPECT_EQ(peer->getTaskState(), TaskContext::Init);
    EXPECT_TRUE(soon([&] { return out.write(1) == NotConnected; }));
}

TEST_F(CorbaProcesses, ShutdownEndsTheOther) {
    OperationCaller<void()> shutdown(peer->getOperation("shutdown"));
    ASSERT_TRUE(shutdown.ready());
    shutdown();
    EXPECT_TRUE(child->waitForOutput("ended", std::chrono::seconds(20)));
}
