// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Peers come, go and restart, operations are called and statistics are read while a chain runs.
#include "chain_fixture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>

namespace {

using namespace chain_test;

class ChainThreads : public Chained {
protected:
    void SetUp() override { thread(0.0005); }
    void TearDown() override {
        chain->stop();
        for (const auto& member : members) member->stop();
    }
    static bool goesOn(std::chrono::steady_clock::time_point end) { return std::chrono::steady_clock::now() < end; }
};

TEST_F(ChainThreads, EverythingAtOnce) {
    LogText log;
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Critical);
    set(*chain, "report_every", 5);
    for (const char* name : {"a", "b"}) members.push_back(std::make_unique<Member>(name, nullptr));
    for (const auto& member : members) {
        enslave(*chain, *member);
        ASSERT_TRUE(member->start());
    }
    ASSERT_TRUE(chain->start());
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    std::atomic<int> lives{0}, calls{0};
    std::vector<std::thread> threads;
    threads.emplace_back([&] {  // members that come and go
        while (goesOn(end)) {
            Member guest("guest", nullptr);
            enslave(*chain, guest);
            guest.start();
            std::this_thread::sleep_for(std::chrono::microseconds(lives % 3 == 0 ? 1500 : 100));
            ++lives;
        }
    });
    threads.emplace_back([&] {  // calls
        RTT::OperationCaller<std::string()> hello(members[0]->getOperation("hello"),
                                                  RTT::internal::GlobalEngine::Instance());
        RTT::OutputPort<int> out("out");
        out.connectTo(&members[1]->event);
        while (goesOn(end)) {
            calls += hello() == "hello from a";
            out.write(1);
        }
    });
    threads.emplace_back([&] {  // readers
        RTT::InputPort<OCL::ChainStatistics> port("port");
        port.connectTo(chain->getPort("statistics"));
        OCL::ChainStatistics sample;
        while (goesOn(end)) {
            port.read(sample);
            (void)chain->stats();
            (void)chain->timeReport();
            (void)chain->order();
            (void)chain->describe();
            chain->resetStats();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    threads.emplace_back([&] {  // a member that restarts
        while (goesOn(end)) {
            members[1]->stop();
            members[1]->setActivity(new RTT::extras::SlaveActivity(chain->getActivity()));
            members[1]->start();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    for (std::thread& one : threads) one.join();
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
    EXPECT_LT(10, lives);
    EXPECT_LT(10, calls);
    const int before = members[0]->updates;
    EXPECT_TRUE(within(5, [&] { return members[0]->updates > before; }));
    EXPECT_TRUE(within(5, [&] { return chain->order() == Strings({"a", "b"}); }));
}

TEST_F(ChainThreads, StartsAndStopsWithCallsInBetween) {
    members.push_back(std::make_unique<Member>("a", nullptr));
    enslave(*chain, *members[0]);
    ASSERT_TRUE(members[0]->start());
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    std::atomic<int> calls{0};
    std::thread caller([&] {
        RTT::OperationCaller<std::string()> hello(members[0]->getOperation("hello"),
                                                  RTT::internal::GlobalEngine::Instance());
        while (goesOn(end)) calls += hello() == "hello from a";
    });
    int starts = 0;
    while (goesOn(end)) starts += chain->start() && chain->stop();
    caller.join();
    EXPECT_LT(5, starts);
    EXPECT_LT(5, calls);
}

TEST_F(ChainThreads, ChainsThatAreDestroyedWhileTheyRun) {
    for (int i = 0; i < 50; ++i) {
        auto other = std::make_unique<OCL::Chain>("other");
        other->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.0005, nullptr, "other"));
        Member guest("guest", nullptr);
        enslave(*other, guest);
        ASSERT_TRUE(guest.start() && other->start());
        Member more("more", nullptr);
        other->addPeer(&more);
        std::this_thread::sleep_for(std::chrono::microseconds(100 * (i % 10)));
        other.reset();
        guest.stop();
    }
}

}  // namespace
