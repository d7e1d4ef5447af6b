// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// No node, no master, busy components, and servers that go away while clients call.
#include "reconfigure_fixture.hpp"

#include "../flow/log_capture.hpp"

#include <rtt/extras/SlaveActivity.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace {

using namespace reconfigure_test;
using flow_test::LogCapture;
using testing::AllOf;
using testing::HasSubstr;

struct Simple : RTT::TaskContext {
    explicit Simple(const std::string& name = "simple") : TaskContext(name) { addProperty("x", x); }
    ~Simple() override { stop(); }
    double x = 1;
};

TEST(RosReconfigureFaults, WithoutANodeNothingIsAdvertised) {
    load();
    Simple simple;
    ServerBase& server = serverOf(simple);
    LogCapture log;
    EXPECT_FALSE(server.advertise());
    EXPECT_FALSE(server.updated());
    EXPECT_TRUE(server.refresh());
    server.shutdown();
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("'simple'"), HasSubstr("rtt_rosnode")));
}

TEST(RosReconfigureFaults, NamesAndTheMasterAreChecked) {
    Node node;
    Simple simple, deployer("Deployer"), odd("not a name");
    LogCapture log;
    EXPECT_FALSE(serverOf(odd).advertise());
    EXPECT_FALSE(serverOf(simple).advertise("/a b"));
    EXPECT_TRUE(serverOf(deployer).advertise());
    EXPECT_FALSE(serverOf(simple).advertise("~"));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("'not a name'"), HasSubstr("/a b"), HasSubstr("a server there already")));
    EXPECT_TRUE(set("/tester", a("x", 3.0)));
    EXPECT_EQ(3, deployer.x);
    EXPECT_TRUE(serverOf(simple).advertise("/one"));
    EXPECT_TRUE(serverOf(simple).advertise("/other"));
    EXPECT_TRUE(set("/other", a("x", 4.0)));
    EXPECT_FALSE(set("/one", a("x", 5.0)));
    node.master().stop();
    LogCapture second;
    EXPECT_FALSE(serverOf(simple).advertise("/third"));
    EXPECT_THAT(second.finish(), HasSubstr("does not answer"));
}

TEST(RosReconfigureFaults, AMasterThatReturnsKnowsTheServer) {
    Node node;
    Simple simple;
    ASSERT_TRUE(serverOf(simple).advertise("/s"));
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    node.master().stop();
    ASSERT_TRUE(node.master().start());
    ASSERT_TRUE(soon([&] { return set("/s", a("x", 2.0)); }));
    EXPECT_EQ(2, simple.x);
}

TEST(RosReconfigureFaults, AComponentThatNobodyExecutesIsServed) {
    const Node node;
    Simple simple;
    ASSERT_TRUE(simple.setActivity(new RTT::extras::SlaveActivity()));
    ASSERT_TRUE(serverOf(simple).advertise("/s"));
    EXPECT_TRUE(set("/s", a("x", 2.0)));
    EXPECT_EQ(2, simple.x);
    simple.getActivity()->stop();
    EXPECT_TRUE(set("/s", a("x", 3.0)));
    EXPECT_EQ(3, simple.x);
}

struct Busy : Simple {
    Busy() : Simple("busy") { addOperation("updateProperties", &Busy::take, this, RTT::OwnThread); }
    ~Busy() override { stop(); }
    bool take(const RTT::PropertyBag&, unsigned) {
        if (wantsShutdown) dynamic_cast<ServerBase&>(*provides("reconfigure")).shutdown();
        return true;
    }
    void updateHook() override {
        isIn = true;
        while (mustWait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    bool breakUpdateHook() override { return true; }
    std::atomic<bool> mustWait{false}, isIn{false}, wantsShutdown{false};
};

TEST(RosReconfigureFaults, ShutdownEndsCallsThatWaitForABusyComponent) {
    const Node node;
    Busy busy;
    ServerBase& server = serverOf(busy);
    ASSERT_TRUE(server.advertise("/b"));
    busy.mustWait = true;
    ASSERT_TRUE(busy.start());
    busy.trigger();
    ASSERT_TRUE(soon([&] { return busy.isIn.load(); }));
    std::atomic<int> refused{0};
    std::vector<std::thread> clients;
    for (int i = 0; i != 3; ++i) clients.emplace_back([&] { refused += !set("/b", a("x", 5.0)); });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const auto begin = std::chrono::steady_clock::now();
    server.shutdown();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
    for (std::thread& client : clients) client.join();
    EXPECT_EQ(3, refused);
    busy.mustWait = false;
}

TEST(RosReconfigureFaults, ShutdownWithinARequestIsRefused) {
    const Node node;
    Busy busy;
    ASSERT_TRUE(serverOf(busy).advertise("/b"));
    ASSERT_TRUE(busy.start());
    busy.wantsShutdown = true;
    LogCapture log;
    EXPECT_TRUE(set("/b", a("x", 5.0)));
    EXPECT_THAT(log.finish(), HasSubstr("a request of a client is being executed"));
    EXPECT_TRUE(set("/b", a("x", 6.0)));
}

TEST(RosReconfigureFaults, AServerThatOutlivesItsComponentRefuses) {
    const Node node;
    auto simple = std::make_unique<Simple>();
    ASSERT_TRUE(serverOf(*simple).advertise("/s"));
    const RTT::Service::shared_ptr kept = simple->provides("reconfigure");
    simple.reset();
    LogCapture log;
    EXPECT_FALSE(set("/s", a("x", 5.0)));
    EXPECT_FALSE(dynamic_cast<ServerBase&>(*kept).refresh());
    EXPECT_THAT(log.finish(), HasSubstr("takes no messages"));
}

TEST(RosReconfigureFaults, ComponentsAreDestroyedWhileClientsCall) {
    const Node node;
    std::atomic<bool> isOver{false};
    std::atomic<int> calls{0};
    std::thread client([&] {
        while (!isOver) calls += set("/s", a("x", 2.0));
    });
    for (int i = 0; i != 30; ++i) {
        auto simple = std::make_unique<Simple>();
        ASSERT_TRUE(serverOf(*simple).advertise("/s"));
        ASSERT_TRUE(simple->start());
        const int before = calls;
        EXPECT_TRUE(i % 3 != 0 || soon([&] { return calls != before; }));
    }
    isOver = true;
    client.join();
    EXPECT_GT(calls, 0);
}

}  // namespace
