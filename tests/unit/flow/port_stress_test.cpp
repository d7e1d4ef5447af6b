// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports under load: samples flow while connections come and go and ports are destroyed.
#include "samples.hpp"

#include <rtt/Port.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

using namespace RTT;
using namespace flow_test;

namespace {

std::vector<ConnPolicy> policies() {
    std::vector<ConnPolicy> all;
    for (const int lock : {ConnPolicy::LOCKED, ConnPolicy::LOCK_FREE}) {
        all.push_back(ConnPolicy::data(lock));
        all.push_back(ConnPolicy::buffer(5, lock, true));
        all.push_back(ConnPolicy::circularBuffer(5, lock, true));
    }
    for (ConnPolicy& policy : all) policy.max_threads = 8;
    return all;
}

template <class S>
void trafficDuringStorm(const ConnPolicy& policy) {
    OutputPort<S> out1("out1"), out2("out2");
    InputPort<S> in1("in1"), in2("in2");
    std::atomic<bool> stop{false};
    std::atomic<unsigned> torn{0};
    std::vector<std::thread> threads;
    std::uint64_t writer = 0;
    for (OutputPort<S>* out : {&out1, &out2})
        threads.emplace_back([&, out, id = writer++] {
            S sample;
            for (std::uint64_t n = 1; !stop; ++n) {
                fill(sample, id, n);
                out->write(sample);
            }
        });
    for (InputPort<S>* in : {&in1, &in2})
        threads.emplace_back([&, in] {
            S sample;
            while (!stop)
                if (in->read(sample) != NoData && !intact(sample)) ++torn;
        });
    // Both ends connect and disconnect at once.
    const std::uint64_t rounds = stressCount(300);
    std::thread left([&] {
        for (std::uint64_t i = 0; i < rounds; ++i) {
            out1.createConnection(in1, policy);
            out1.createConnection(in2, policy);
            out1.disconnect();
            out2.connectTo(&in1, policy);
        }
    });
    std::thread right([&] {
        for (std::uint64_t i = 0; i < rounds; ++i) {
            in1.connectTo(&out2, policy);
            in2.disconnect();
            in1.disconnect(&out2);
            in1.disconnect();
            out1.setDataSample(S());
        }
    });
    left.join();
    right.join();
    stop = true;
    for (std::thread& t : threads) t.join();
    EXPECT_EQ(torn, 0u) << policy;
    out1.disconnect();
    out2.disconnect();
    if (policy.buffer_policy == Shared) {  // readers stay in it without writers
        in1.disconnect();
        in2.disconnect();
    }
    EXPECT_FALSE(in1.connected() || in2.connected());
    internal::Reclaimer::collect();  // what a thread inside kept from the last disconnecting
    EXPECT_EQ(internal::Reclaimer::pending(), 0u);
}

}  // namespace

TEST(PortStress, ConnectAndDisconnectFromBothEndsDuringTrafficOfPlainSamples) {
    for (const ConnPolicy& policy : policies()) trafficDuringStorm<Plain>(policy);
}

TEST(PortStress, ConnectAndDisconnectFromBothEndsDuringTrafficOfDeepSamples) {
    for (const ConnPolicy& policy : policies()) trafficDuringStorm<Deep>(policy);
}

TEST(PortStress, SharedStoragesDuringTraffic) {
    for (const BufferPolicy kind : {PerInputPort, PerOutputPort, Shared}) {
        ConnPolicy policy = ConnPolicy::circularBuffer(5);
        policy.buffer_policy = kind;
        if (kind == Shared) policy.name_id = "stress";
        trafficDuringStorm<Deep>(policy);
    }
}

TEST(PortStress, ReadersDisappearWhileTheyAreWrittenTo) {
    OutputPort<Deep> out("out");
    std::atomic<bool> stop{false};
    std::thread writer([&] {
        Deep sample;
        for (std::uint64_t n = 1; !stop; ++n) {
            fill(sample, 0, n);
            out.write(sample);
        }
    });
    const std::uint64_t rounds = stressCount(300);
    for (std::uint64_t i = 0; i < rounds; ++i) {
        InputPort<Deep> in("in");
        ASSERT_TRUE(out.createConnection(in, i % 2 ? ConnPolicy::buffer(4) : ConnPolicy::data()));
        Deep got;
        while (in.read(got) != NewData) std::this_thread::yield();
        EXPECT_TRUE(intact(got));
    }
    stop = true;
    writer.join();
    EXPECT_FALSE(out.connected());
}

TEST(PortStress, WritersDisappearWhileTheyAreReadFrom) {
    InputPort<Deep> in("in");
    std::atomic<bool> stop{false};
    std::atomic<unsigned> torn{0};
    std::thread reader([&] {
        Deep got;
        while (!stop)
            if (in.read(got) == NewData && !intact(got)) ++torn;
    });
    const std::uint64_t rounds = stressCount(300);
    Deep sample;
    for (std::uint64_t i = 1; i <= rounds; ++i) {
        OutputPort<Deep> out("out");
        fill(sample, 0, i);
        out.write(sample);
        ASSERT_TRUE(in.connectTo(&out, ConnPolicy::data()));
        out.write(sample);
    }
    stop = true;
    reader.join();
    EXPECT_EQ(torn, 0u);
    EXPECT_FALSE(in.connected());
}

TEST(PortStress, BufferedSamplesArriveOnceAndInOrder) {
    OutputPort<Plain> out("out");
    InputPort<Plain> in("in");
    out.createConnection(in, ConnPolicy::buffer(16));
    const std::uint64_t count = stressCount(50000);
    std::thread writer([&] {
        Plain sample;
        for (std::uint64_t n = 1; n <= count; ++n) {
            fill(sample, 0, n);
            while (out.write(sample) != WriteSuccess) std::this_thread::yield();
        }
    });
    Plain got;
    for (std::uint64_t expected = 1; expected <= count;) {
        if (in.read(got, false) != NewData) {
            std::this_thread::yield();
            continue;
        }
        ASSERT_EQ(got.serial, expected++);
        ASSERT_TRUE(intact(got));
    }
    writer.join();
    EXPECT_EQ(in.read(got), OldData);
}
