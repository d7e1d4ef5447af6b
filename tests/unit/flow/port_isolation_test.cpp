// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Who is slow, stopped or dead in the middle of a read or write hinders nobody else.
#include <rtt/Port.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <vector>

using namespace RTT;

namespace {

/** Threads that set `stopsHere` stop in the next assignment of a sample until the gate opens. */
struct Gate {
    std::atomic<bool> open{false};
    std::atomic<int> stopped{0};
};
Gate* gate = nullptr;
thread_local bool stopsHere = false;

struct Sample {
    Sample(int v = 0) : value(v) {}
    Sample(const Sample&) = default;
    Sample& operator=(const Sample& o) {
        value = o.value;
        if (!stopsHere) return *this;
        stopsHere = false;
        ++gate->stopped;
        while (!gate->open) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return *this;
    }
    int value;
};

ConnPolicy policyOf(int type, int owner) {
    ConnPolicy policy(type, ConnPolicy::LOCK_FREE);
    policy.buffer_policy = owner;
    policy.size = 4;
    return policy;
}

class Isolation : public testing::TestWithParam<std::tuple<int, int>> {
protected:
    void SetUp() override { gate = &gate_; }
    void TearDown() override {
        gate_.open = true;
        for (std::thread& t : threads_) t.join();
        gate = nullptr;
    }
    /** Runs `work` in a thread that stops within its first assignment. */
    template <class F>
    void stopWithin(F work) {
        const int before = gate_.stopped;
        threads_.emplace_back([work] {
            stopsHere = true;
            work();
        });
        while (gate_.stopped == before) std::this_thread::yield();
    }
    ConnPolicy policy() const { return policyOf(std::get<0>(GetParam()), std::get<1>(GetParam())); }
    bool sharedByReaders() const {
        return std::get<1>(GetParam()) == PerOutputPort || std::get<1>(GetParam()) == Shared;
    }

    OutputPort<Sample> out1{"out1", false}, out2{"out2", false};
    InputPort<Sample> in1{"in1"}, in2{"in2"};

private:
    Gate gate_;
    std::vector<std::thread> threads_;
};

}  // namespace

TEST_P(Isolation, AReaderThatStoppedWithinAReadHindersNeitherWriterNorOtherReaders) {
    ASSERT_TRUE(out1.createConnection(in1, policy()));
    ASSERT_TRUE(out1.createConnection(in2, policy()));
    out1.write(1);
    stopWithin([this] {
        Sample got;
        (void)in1.read(got);
    });
    Sample got;
    if (!sharedByReaders()) {
        EXPECT_EQ(in2.read(got), NewData);
    }
    const bool buffer = std::get<0>(GetParam()) == ConnPolicy::BUFFER;
    for (int i = 2; i < 100; ++i) {
        const WriteStatus status = out1.write(i);
        // The buffer of the one that stopped fills, which its writer is told.
        EXPECT_EQ(status, buffer && !sharedByReaders() && i > 5 ? WriteFailure : WriteSuccess) << i;
        ASSERT_EQ(in2.read(got), NewData);
        ASSERT_EQ(got.value, i);
    }
}

TEST_P(Isolation, AWriterThatStoppedWithinAWriteHindersNeitherReadersNorOtherWriters) {
    ASSERT_TRUE(out1.createConnection(in1, policy()));
    ASSERT_TRUE(out2.createConnection(in1, policy()));
    stopWithin([this] { (void)out1.write(1); });
    Sample got;
    for (int i = 2; i < 100; ++i) {
        EXPECT_EQ(out2.write(i), WriteSuccess);
        ASSERT_EQ(in1.read(got), NewData);
        ASSERT_EQ(got.value, i);
    }
}

TEST_P(Isolation, ConnectingAndDisconnectingDoNotWaitForAReaderThatStopped) {
    ASSERT_TRUE(out1.createConnection(in1, policy()));
    out1.write(1);
    stopWithin([this] {
        Sample got;
        (void)in1.read(got);
    });
    out1.disconnect();
    in1.disconnect();
    EXPECT_FALSE(in1.connected());
    ASSERT_TRUE(out1.createConnection(in2, policy()));
    EXPECT_EQ(out1.write(2), WriteSuccess);
    Sample got;
    EXPECT_EQ(in2.read(got), NewData);
    EXPECT_TRUE(in2.disconnect(&out1));
}

INSTANTIATE_TEST_SUITE_P(EveryLockFreeStorage, Isolation,
                         testing::Combine(testing::Values(ConnPolicy::DATA, ConnPolicy::BUFFER,
                                                          ConnPolicy::CIRCULAR_BUFFER),
                                          testing::Values(PerConnection, PerInputPort, PerOutputPort, Shared)));

TEST(IsolationOfConnections, AnotherReadersLockIsNoConcernOfMine) {
    // A LOCKED connection whose reader holds the lock makes its writer wait, but no reader of another connection.
    Gate own;
    gate = &own;
    OutputPort<Sample> out("out", false), other("other", false);
    InputPort<Sample> locked("locked"), in("in");
    ASSERT_TRUE(out.createConnection(locked, ConnPolicy::data(ConnPolicy::LOCKED)));
    ASSERT_TRUE(other.createConnection(in, ConnPolicy::data(ConnPolicy::LOCKED)));
    out.write(1);
    std::thread stopped([&] {
        stopsHere = true;
        Sample got;
        (void)locked.read(got);
    });
    while (own.stopped == 0) std::this_thread::yield();
    Sample got;
    EXPECT_EQ(other.write(2), WriteSuccess);
    EXPECT_EQ(in.read(got), NewData);
    own.open = true;
    stopped.join();
    gate = nullptr;
}

TEST(IsolationOfConnections, AReaderThatNeverReadsOrDiesHindersNobody) {
    OutputPort<int> out("out");
    InputPort<int> alive("alive"), idle("idle");
    out.createConnection(alive, ConnPolicy::buffer(2));
    ConnPolicy optional = ConnPolicy::buffer(2);
    optional.mandatory = false;
    out.createConnection(idle, optional);
    std::unique_ptr<InputPort<int>> dying(new InputPort<int>("dying"));
    out.createConnection(*dying, ConnPolicy::data());
    int got = 0;
    for (int i = 1; i < 1000; ++i) {
        if (i == 500) dying.reset();
        ASSERT_EQ(out.write(i), WriteSuccess);
        ASSERT_EQ(alive.read(got), NewData);
        ASSERT_EQ(got, i);
    }
}
