// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Three writers and three readers on every kind of connection, each sample with its writer, number and checksum: nothing
// torn, nothing out of order, and whatever did not arrive was counted as dropped. Then connecting at random.
#include "samples.hpp"

#include <rtt/Logger.hpp>
#include <rtt/Port.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/flow/storage_core.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <set>
#include <thread>
#include <tuple>
#include <vector>

using namespace RTT;
using namespace flow_test;

namespace {

constexpr std::size_t kPorts = 3;

/** What one reader got from each writer. */
struct Tally {
    std::uint64_t count[kPorts] = {}, last[kPorts] = {};
    std::uint64_t torn = 0, disordered = 0;

    template <class S>
    void take(const S& sample) {
        if (!intact(sample) || sample.writer >= kPorts) {
            ++torn;
            return;
        }
        if (sample.serial <= last[sample.writer]) ++disordered;
        last[sample.writer] = sample.serial;
        ++count[sample.writer];
    }
};

template <class S>
class Storm {
public:
    explicit Storm(const ConnPolicy& policy) : policy_(policy) {
        for (OutputPort<S>& out : outs)
            for (InputPort<S>& in : ins) EXPECT_TRUE(out.createConnection(in, policy_)) << policy_;
    }

    void run(std::uint64_t each) {
        std::atomic<unsigned> writing{kPorts};
        std::atomic<std::uint64_t> refused{0};
        std::vector<std::thread> threads;
        for (std::size_t w = 0; w < kPorts; ++w)
            threads.emplace_back([&, w] {
                S sample;
                for (std::uint64_t n = 1; n <= each; ++n) {
                    fill(sample, w, n);
                    if (outs[w].write(sample) != WriteSuccess) ++refused;
                    if (n % 64 == 0) std::this_thread::yield();
                }
                --writing;
            });
        for (std::size_t r = 0; r < kPorts; ++r)
            threads.emplace_back([&, r] {
                S sample;
                unsigned idle = 0;
                for (;;) {
                    const bool done = writing == 0;
                    const FlowStatus status = ins[r].read(sample);
                    if (status == NewData) tallies[r].take(sample);
                    if (status == OldData && !intact(sample)) ++tallies[r].torn;
                    if (status != NewData && done) return;
                    if (status != NewData && ++idle % 16 == 0) std::this_thread::yield();
                }
            });
        for (std::thread& t : threads) t.join();
        check(each, refused);
    }

private:
    void check(std::uint64_t each, std::uint64_t refused) {
        std::uint64_t got = 0, dropped = 0;
        for (const Tally& tally : tallies) {
            EXPECT_EQ(tally.torn, 0u) << policy_;
            EXPECT_EQ(tally.disordered, 0u) << policy_;
            for (const std::uint64_t count : tally.count) got += count;
        }
        std::set<internal::StorageCore*> storages;
        for (OutputPort<S>& out : outs)
            for (const auto& channel : out.getManager()->getChannels())
                if (storages.insert(channel.template get<1>()->storageCore()).second)
                    dropped += channel.template get<1>()->storageCore()->store().dropped();
        // A sample goes into every storage of its writer once.
        const bool perReader = policy_.buffer_policy == PerConnection || policy_.buffer_policy == PerInputPort;
        const std::uint64_t stored = kPorts * each * (perReader ? kPorts : 1);
        if (policy_.type == ConnPolicy::DATA) {
            EXPECT_LE(got, stored) << policy_;
            if (policy_.buffer_policy == PerConnection) {
                for (const Tally& tally : tallies)
                    for (const std::uint64_t last : tally.last) EXPECT_EQ(last, each) << policy_;
            }
        } else {
            EXPECT_EQ(got + dropped, stored) << policy_;
        }
        if (policy_.type != ConnPolicy::BUFFER) {
            EXPECT_EQ(refused, 0u) << policy_;
        }
        if (policy_.type == ConnPolicy::BUFFER) {
            EXPECT_LE(refused, dropped) << policy_;
        }
    }

    OutputPort<S> outs[kPorts];
    InputPort<S> ins[kPorts];
    Tally tallies[kPorts];
    ConnPolicy policy_;
};

/** type, lock policy, buffer policy */
class PortStorm : public testing::TestWithParam<std::tuple<int, int, int>> {
protected:
    ConnPolicy policy() const {
        ConnPolicy made(std::get<0>(GetParam()), std::get<1>(GetParam()));
        made.buffer_policy = std::get<2>(GetParam());
        made.size = 6;
        return made;
    }
};

TEST_P(PortStorm, KeepsPlainSamplesWholeInOrderAndCounted) { Storm<Plain>(policy()).run(stressCount(1500)); }
TEST_P(PortStorm, KeepsDeepSamplesWholeInOrderAndCounted) { Storm<Deep>(policy()).run(stressCount(700)); }

INSTANTIATE_TEST_SUITE_P(EveryPolicy, PortStorm,
                         testing::Combine(testing::Values(ConnPolicy::DATA, ConnPolicy::BUFFER,
                                                          ConnPolicy::CIRCULAR_BUFFER),
                                          testing::Values(ConnPolicy::LOCKED, ConnPolicy::LOCK_FREE),
                                          testing::Values(PerConnection, PerInputPort, PerOutputPort, Shared)));

/** Silence for refusals that are meant to happen. */
class Quiet {
public:
    Quiet() : before_(Logger::Instance()->getLogLevel()) { Logger::Instance()->setLogLevel(Logger::Never); }
    ~Quiet() { Logger::Instance()->setLogLevel(before_); }

private:
    Logger::LogLevel before_;
};

ConnPolicy anyPolicy(std::mt19937& random) {
    ConnPolicy policy(static_cast<int>(random() % 3), random() % 2 ? ConnPolicy::LOCKED : ConnPolicy::LOCK_FREE);
    policy.buffer_policy = random() % 3 == 0 ? static_cast<int>(1 + random() % 4) : PerConnection;
    policy.size = static_cast<int>(random() % 4);
    policy.init = random() % 2;
    policy.max_threads = 10;
    if (policy.buffer_policy == Shared) policy.name_id = "storm";
    return policy;
}

template <class S>
void connectAtRandom(std::uint64_t operations) {
    const Quiet quiet;
    OutputPort<S> outs[kPorts];
    InputPort<S> ins[kPorts];
    std::atomic<bool> stop{false};
    std::atomic<unsigned> torn{0};
    std::vector<std::thread> traffic, connecting;
    for (std::size_t p = 0; p < kPorts; ++p) {
        traffic.emplace_back([&, p] {
            S sample;
            for (std::uint64_t n = 1; !stop; ++n) {
                fill(sample, p, n);
                (void)outs[p].write(sample);
                if (n % 64 == 0) std::this_thread::yield();
            }
        });
        traffic.emplace_back([&, p] {
            S sample;
            unsigned reads = 0;
            while (!stop) {
                if (ins[p].read(sample) != NoData && !intact(sample)) ++torn;
                if (++reads % 64 == 0) std::this_thread::yield();
            }
        });
        connecting.emplace_back([&, p] {
            std::mt19937 random(static_cast<unsigned>(p));
            for (std::uint64_t n = 0; n < operations; ++n) {
                OutputPort<S>& out = outs[random() % kPorts];
                InputPort<S>& in = ins[random() % kPorts];
                switch (random() % 10) {
                    case 0: out.disconnect(); break;
                    case 1: in.disconnect(); break;
                    case 2: out.disconnect(&in); break;
                    case 3: in.disconnect(&out); break;
                    case 4: out.setDataSample(S()); break;
                    case 5: in.clear(); break;
                    case 6: (void)out.getManager()->getChannels(); break;
                    case 7: (void)in.connectTo(&out, anyPolicy(random)); break;
                    default: (void)out.connectTo(&in, anyPolicy(random)); break;
                }
            }
        });
    }
    for (std::thread& t : connecting) t.join();
    stop = true;
    for (std::thread& t : traffic) t.join();
    EXPECT_EQ(torn, 0u);
    for (OutputPort<S>& out : outs) out.disconnect();
    for (InputPort<S>& in : ins) in.disconnect();  // readers of a shared connection are left
    for (std::size_t p = 0; p < kPorts; ++p) EXPECT_FALSE(outs[p].connected() || ins[p].connected());
    internal::Reclaimer::collect();
    EXPECT_EQ(internal::Reclaimer::pending(), 0u);
}

}  // namespace

// Three threads connect and disconnect: 10^6 times in both tests together.
TEST(ConnectionStorm, OfAllPoliciesDuringTrafficOfPlainSamples) { connectAtRandom<Plain>(stressCount(170000)); }
TEST(ConnectionStorm, OfAllPoliciesDuringTrafficOfDeepSamples) { connectAtRandom<Deep>(stressCount(170000)); }
