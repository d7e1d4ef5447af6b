// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Another process that is killed, stopped, ended or started again, as its peers see it.
#include <rtt/OperationCaller.hpp>
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include "../flow/log_capture.hpp"
#include "peer_fixture.hpp"

#include <omniORB4/omniORB.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

using namespace RTT;
using corba_test::soon;

namespace {

typedef std::chrono::steady_clock Clock;

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

class CorbaFaults : public corba_test::PeerFixture {
protected:
    struct Here : TaskContext {
        Here() : TaskContext("here") {
            addPort(out);
            addPort(in);
        }
        OutputPort<double> out{"out"};
        InputPort<double> in{"in"};
    };

    void connect(const ConnPolicy& policy) {
        ASSERT_TRUE(peer->configure());
        ASSERT_TRUE(peer->start());
        ASSERT_TRUE(here.out.connectTo(peer->getPort("echo"), policy));
        ASSERT_TRUE(peer->getPort("out")->connectTo(&here.in, policy));
    }
    void expectSamplesCross(double sample) {
        double got = 0;
        EXPECT_TRUE(soon([&] {
            (void)here.out.write(sample);
            return here.in.read(got) == NewData && got == 2 * sample;
        }));
    }
    Here here;
};

/** For all calls of this process. */
class TimeLimit {
public:
    explicit TimeLimit(CORBA::ULong milliseconds) { omniORB::setClientCallTimeout(milliseconds); }
    ~TimeLimit() { omniORB::setClientCallTimeout(0); }
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;
};

}  // namespace

TEST_F(CorbaFaults, ConnectionsReturnWithAKilledProcess) {
    connect(ConnPolicy::data());
    OperationCaller<int(int, int)> add(peer->getOperation("add"));
    expectSamplesCross(1);
    end(SIGKILL);
    EXPECT_TRUE(soon([&] { return !peer->ready() && !here.out.connected() && !here.in.connected(); }));
    EXPECT_THROW(add(1, 2), std::runtime_error);
    EXPECT_FALSE(peer->getProperty("gain")->getDataSource()->evaluate());
    begin();
    EXPECT_TRUE(soon([&] { return peer->ready(); }));
    EXPECT_EQ(add(1, 2), 3);
    EXPECT_TRUE(peer->getProperty("gain")->getDataSource()->evaluate());
    EXPECT_TRUE(peer->configure());
    EXPECT_TRUE(peer->start());
    EXPECT_TRUE(soon([&] { return here.out.connected() && here.in.connected(); }));
    expectSamplesCross(2);
    EXPECT_TRUE(here.out.connectedTo(peer->getPort("echo")));
    EXPECT_TRUE(peer->getPort("out")->connectedTo(&here.in));
}

TEST_F(CorbaFaults, ConnectionsReturnWithAProcessThatEndedInOrder) {
    connect(ConnPolicy::buffer(10));
    OperationCaller<void()>(peer->getOperation("shutdown"))();
    ASSERT_TRUE(child->waitForOutput("ended", std::chrono::seconds(20)));
    (void)child->finish();
    EXPECT_TRUE(soon([&] { return !peer->ready() && !here.out.connected() && !here.in.connected(); }));
    begin();
    EXPECT_TRUE(soon([&] { return peer->ready(); }));
    EXPECT_TRUE(peer->configure());
    EXPECT_TRUE(peer->start());
    EXPECT_TRUE(soon([&] { return here.out.connected() && here.in.connected(); }));
    expectSamplesCross(3);
}

TEST_F(CorbaFaults, WhatWasDisconnectedStaysSo) {
    connect(ConnPolicy::data());
    here.out.disconnect();
    here.in.disconnect();
    EXPECT_TRUE(soon([&] { return !peer->getPort("echo")->connected() && !peer->getPort("out")->connected(); }));
    end(SIGKILL);
    EXPECT_TRUE(soon([&] { return !peer->ready(); }));
    begin();
    EXPECT_TRUE(soon([&] { return peer->ready(); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // more than a period of the watch
    EXPECT_FALSE(here.out.connected());
    EXPECT_FALSE(here.in.connected());
}

TEST_F(CorbaFaults, AStoppedProcessDelaysNobody) {
    connect(ConnPolicy::buffer(10));
    InputPort<double> near("near");
    here.addPort(near);
    ASSERT_TRUE(here.out.connectTo(&near, ConnPolicy::circularBuffer(1000)));
    expectSamplesCross(1);
    suspend();
    const Clock::time_point begin = Clock::now();
    double got = 0;
    for (int i = 0; i != 1000; ++i) (void)here.out.write(i);
    while (near.read(got) == NewData) {
    }
    EXPECT_EQ(got, 999);
    EXPECT_LT(secondsSince(begin), 1) << "the writer and a local reader wait for nobody";
    EXPECT_EQ(peer->getTaskState(), TaskContext::Init);
    EXPECT_LT(secondsSince(begin), 10) << "a question has a time limit";
    const Clock::time_point again = Clock::now();
    for (int i = 0; i != 100; ++i) EXPECT_FALSE(peer->isRunning());
    EXPECT_LT(secondsSince(again), 1) << "and is not asked again meanwhile";
    child->send(SIGCONT);
    EXPECT_TRUE(soon([&] { return peer->ready() && peer->isRunning(); }));
    expectSamplesCross(4);
}

TEST_F(CorbaFaults, SamplesOfAPauseArriveAfterIt) {
    connect(ConnPolicy::buffer(10));
    expectSamplesCross(1);
    suspend();
    EXPECT_EQ(here.out.write(5), WriteSuccess);
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));  // longer than one sample may take
    EXPECT_EQ(here.out.write(6), WriteSuccess);
    EXPECT_EQ(here.out.write(7), WriteSuccess);
    child->send(SIGCONT);
    double got = 0;
    EXPECT_TRUE(soon([&] {
        double sample = 0;
        while (here.in.read(sample) == NewData) got = sample;
        return got == 14;
    })) << got;
}

TEST_F(CorbaFaults, EveryBufferPolicyEndsAtBothSides) {
    for (const int buffers : {PerConnection, PerInputPort, PerOutputPort}) {
        SCOPED_TRACE(buffers);
        ConnPolicy policy = ConnPolicy::buffer(10);
        policy.buffer_policy = static_cast<BufferPolicy>(buffers);
        ASSERT_TRUE(here.out.connectTo(peer->getPort("in"), policy));
        EXPECT_TRUE(peer->getPort("in")->connected());
        here.out.disconnect();
        EXPECT_TRUE(soon([&] { return !peer->getPort("in")->connected(); }));
        ASSERT_TRUE(peer->getPort("out")->connectTo(&here.in, policy));
        EXPECT_TRUE(here.in.connected());
        here.in.disconnect();
        EXPECT_TRUE(soon([&] { return !peer->getPort("out")->connected(); }));
    }
    ConnPolicy shared = ConnPolicy::buffer(10);
    shared.buffer_policy = Shared;
    EXPECT_FALSE(here.out.connectTo(peer->getPort("in"), shared));
    EXPECT_FALSE(here.out.connected() || peer->getPort("in")->connected());
}

TEST_F(CorbaFaults, AHundredConnections) {
    connect(ConnPolicy::data());
    for (int i = 0; i != 100 && !HasFailure(); ++i) {
        SCOPED_TRACE(i);
        ConnPolicy policy = i % 2 ? ConnPolicy::data() : ConnPolicy::buffer(5);
        policy.pull = i % 3 == 0;
        if (i % 4 < 2) {
            here.out.disconnect();
            ASSERT_TRUE(here.out.connectTo(peer->getPort("echo"), policy));
        } else {
            here.in.disconnect();
            ASSERT_TRUE(peer->getPort("out")->connectTo(&here.in, policy));
        }
        ASSERT_NO_FATAL_FAILURE(expectSamplesCross(i + 0.5));
    }
    EXPECT_EQ(here.out.getManager()->getConnections().size(), 1U);
    EXPECT_EQ(here.in.getManager()->getConnections().size(), 1U);
}

// The component knows no more than the reference of the service that it calls; the proxy is in the same process.
TEST_F(CorbaFaults, AServiceReturnsToThoseThatRequireIt) {
    struct Needy : TaskContext {
        Needy() : TaskContext("needy") { requires_("deep")->addOperationCaller(thrice); }
        OperationCaller<int(int)> thrice{"thrice"};
    } needy;
    const corba::CTaskContext_var own = corba::TaskContextServer::CreateServer(&needy, false);
    const corba::CServiceRequester_var wish = own->getRequester("deep");
    const corba::CService_var sub = peer->server()->getProvider("sub");
    const corba::CService_var deep = sub->getService("deep");
    ASSERT_TRUE(wish->connectTo(deep));
    EXPECT_EQ(needy.thrice(4), 12);
    {
        flow_test::LogCapture log;
        end(SIGKILL);
        for (int i = 0; i != 100; ++i) EXPECT_THROW(needy.thrice(4), std::runtime_error);
        std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // more than a period of the watch
        EXPECT_THROW(needy.thrice(4), std::runtime_error);
        const std::string text = log.finish();
        const std::string line = "component 'deep' of another process does not answer";
        EXPECT_NE(text.find(line), std::string::npos) << text;
        EXPECT_EQ(text.find(line), text.rfind(line)) << "once is enough: " << text;
    }
    begin();
    EXPECT_TRUE(soon([&] {
        try {
            return needy.thrice(5) == 15;
        } catch (const std::runtime_error&) {
            return false;
        }
    }));
    corba::TaskContextServer::CleanupServer(&needy);
}

TEST_F(CorbaFaults, CallsMayHaveATimeLimit) {
    const TimeLimit limit(200);
    OperationCaller<int(int, int)> add(peer->getOperation("add"));
    suspend();
    const Clock::time_point begin = Clock::now();
    EXPECT_THROW(add(1, 2), std::runtime_error);
    EXPECT_LT(secondsSince(begin), 10);
    child->send(SIGCONT);
    EXPECT_TRUE(soon([&] { return peer->ready() && add(1, 2) == 3; }));
}

// Each call of both processes has a time-out.
TEST_F(CorbaFaults, ManyCallsInBothDirectionsAtOnce) {
    constexpr int kThreads = 4;
    const bool isSlow = std::getenv("TSAN_OPTIONS") || std::getenv("ASAN_OPTIONS");
    const int count = (isSlow ? 4000 : 100000) / (2 * kThreads);
    const TimeLimit limit(10000);
    Here other;
    other.addOperation("add", [](int a, int b) { return a + b; });
    ASSERT_TRUE(peer->addPeer(&other));
    std::vector<std::thread> threads;
    std::atomic<int> right{0};
    for (int t = 0; t != kThreads; ++t)
        threads.emplace_back([&] {
            OperationCaller<int(int, int)> add(peer->getOperation("add"));
            OperationCaller<std::string(const std::string&)> own(peer->getOperation("own"));
            for (int i = 0; i != count; ++i) right += i % 2 ? own("x") == "x own" : add(i, i) == 2 * i;
        });
    OperationCaller<int(const std::string&, int, int)> callBack(peer->getOperation("callBack"));
    auto there = callBack.send(other.getName(), kThreads, count);
    for (std::thread& one : threads) one.join();
    EXPECT_EQ(right, kThreads * count);
    int theirs = 0;
    ASSERT_TRUE(soon([&] { return there.collectIfDone(theirs) != SendNotReady; }));
    EXPECT_EQ(theirs, kThreads * count);
    corba::TaskContextServer::CleanupServer(&other);
}

// The other component calls back the one that waits for it, in its own thread.
TEST_F(CorbaFaults, TwoComponentsCallEachOther) {
    struct Caller : TaskContext {
        explicit Caller(TaskContext& other) : TaskContext("caller"), call(other.getOperation("callWished"), engine()) {
            addOperation("wished", &Caller::wished, this, OwnThread);
            addOperation("run", &Caller::run, this, OwnThread);
        }
        ~Caller() override { stopForGood(); }
        int wished(int value) { return engine()->isSelf() ? value + 1 : -2; }
        int run(int count) {
            int good = 0;
            for (int i = 0; i != count; ++i) good += call(i) == i + 1;
            return good;
        }
        OperationCaller<int(int)> call;
    } caller(*peer);
    const corba::CTaskContext_var own = corba::TaskContextServer::CreateServer(&caller, false);
    const corba::CService_var service = own->getProvider("this");
    const corba::CServiceRequester_var wish = peer->server()->getRequester("wish");
    ASSERT_TRUE(wish->connectCallerTo("wished", service));
    OperationCaller<int(int)> run(caller.getOperation("run"), internal::GlobalEngine::Instance());
    EXPECT_EQ(run(200), 200);
    corba::TaskContextServer::CleanupServer(&caller);
}
