// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writing and reading neither allocate, free, lock nor wait once samples are sized; with LOCKED they only lock.
#include <support/real_time_trap.hpp>

#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/rt_string.hpp>

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

using namespace RTT;
using oroforge::test::expectRealTime;
using oroforge::test::RealTimeTrap;

namespace {

typedef std::vector<double> Samples;

/** What a typekit would describe, and the runtime knows nothing about. */
struct Named {
    std::vector<double> values;
    std::string name;
};

struct Pose {
    double values[8];
};

/** What is forbidden with a policy. */
unsigned forbidden(const ConnPolicy& policy) {
    const unsigned heap = RealTimeTrap::kAllocation | RealTimeTrap::kRelease;
    return policy.lock_policy == ConnPolicy::LOCKED ? heap : unsigned(RealTimeTrap::kEverything);
}

class RealTimePath : public testing::TestWithParam<ConnPolicy> {
protected:
    void SetUp() override { OROFORGE_NEEDS_REAL_TIME_TRAP(); }
};

/** One writer and two readers who are behind it, beside it and ahead of it. */
template <class T>
void traffic(OutputPort<T>& out, InputPort<T>& first, InputPort<T>& second, const T& sample, T& got) {
    for (int i = 0; i < 50; ++i) {
        for (int n = 0; n < i % 6; ++n) (void)out.write(sample);
        for (int n = 0; n < i % 4; ++n) (void)first.read(got, n % 2 == 0);
        (void)second.readNewest(got);
        (void)(out.connected() && first.connected());
        if (i % 10 == 0) first.clear();
    }
    (void)out.getLastWrittenValue(got);
}

template <class T>
void trafficOver(const ConnPolicy& policy, const T& sample, bool keep) {
    T got = sample;
    OutputPort<T> out("out", keep);
    InputPort<T> first("first"), second("second");
    out.setDataSample(sample);
    ASSERT_TRUE(out.createConnection(first, policy));
    ASSERT_TRUE(out.createConnection(second, policy));
    expectRealTime([&] { traffic(out, first, second, sample, got); }, forbidden(policy));
}

template <class T>
void trafficOver(const ConnPolicy& policy, const T& sample) {
    trafficOver(policy, sample, true);
    trafficOver(policy, sample, false);
}

}  // namespace

TEST_P(RealTimePath, OfPresizedVectorsIsClean) { trafficOver(GetParam(), Samples(1000, 1.5)); }
TEST_P(RealTimePath, OfNumbersIsClean) { trafficOver(GetParam(), 1.5); }
TEST_P(RealTimePath, OfStructsIsClean) { trafficOver(GetParam(), Pose{{1, 2, 3}}); }
TEST_P(RealTimePath, OfStringsIsClean) { trafficOver(GetParam(), std::string(200, 'x')); }
TEST_P(RealTimePath, OfRealTimeStringsIsClean) { trafficOver(GetParam(), rt_string(200, 'x')); }

TEST_P(RealTimePath, IsCleanOnceTheFirstSampleHasPassed) {
    const auto check = [&](const auto& sample) {
        typedef std::decay_t<decltype(sample)> Sample;
        OutputPort<Sample> out("out");
        InputPort<Sample> first("first"), second("second");
        ASSERT_TRUE(out.createConnection(first, GetParam()));
        ASSERT_TRUE(out.createConnection(second, GetParam()));
        Sample got = sample;
        ASSERT_EQ(out.write(sample), WriteSuccess);
        expectRealTime([&] { traffic(out, first, second, sample, got); }, forbidden(GetParam()));
    };
    check(Samples(500, 2.5));
    check(std::string(200, 'x'));
    check(std::vector<std::string>(3, std::string(200, 'x')));
    check(Named{Samples(500, 2.5), std::string(200, 'x')});
}

// Whether the small ones have been read or not.
TEST_P(RealTimePath, IsCleanOnceALargerSampleHasPassed) {
    const auto check = [&](const auto& small, const auto& large) {
        typedef std::decay_t<decltype(small)> Sample;
        OutputPort<Sample> out("out");
        InputPort<Sample> first("first"), second("second");
        ASSERT_TRUE(out.createConnection(first, GetParam()));
        ASSERT_TRUE(out.createConnection(second, GetParam()));
        Sample got = large;
        for (int i = 0; i < 2; ++i) ASSERT_EQ(out.write(small), WriteSuccess);
        ASSERT_EQ(first.read(got), NewData);
        ASSERT_EQ(out.write(large), WriteSuccess);
        expectRealTime([&] { traffic(out, first, second, large, got); }, forbidden(GetParam()));
    };
    check(Samples(10, 1.5), Samples(500, 2.5));
    check(std::string(), std::string(200, 'x'));
    check(std::vector<std::string>(3, "x"), std::vector<std::string>(3, std::string(200, 'x')));
}

// Zero-copy users ask how many own what they point to.
TEST_P(RealTimePath, DoesNotKeepPointersInElementsThatHoldNoSample) {
    OutputPort<std::shared_ptr<int>> out("out", false);
    InputPort<std::shared_ptr<int>> in("in");
    ASSERT_TRUE(out.createConnection(in, GetParam()));
    std::shared_ptr<int> sample = std::make_shared<int>(1), got;
    ASSERT_EQ(out.write(sample), WriteSuccess);
    EXPECT_EQ(sample.use_count(), 2);
    ASSERT_EQ(in.read(got), NewData);
    EXPECT_EQ(sample.use_count(), 3);
}

TEST_P(RealTimePath, IsCleanAtOnceAfterASampleWasAnnounced) {
    OutputPort<Samples> out("out");
    InputPort<Samples> in("in");
    ASSERT_TRUE(out.createConnection(in, GetParam()));
    const Samples sample(100, 1.5);
    Samples got;
    out.setDataSample(sample);
    in.getDataSample(got);
    EXPECT_EQ(got.size(), 100u);
    expectRealTime(
        [&] {
            for (int i = 0; i < 100; ++i) (void)out.write(sample);
            for (int i = 0; i < 100; ++i) (void)in.read(got);
        },
        forbidden(GetParam()));
}

TEST_P(RealTimePath, WithStorageForEveryBufferPolicyIsClean) {
    for (const BufferPolicy where : {PerConnection, PerInputPort, PerOutputPort, Shared}) {
        ConnPolicy policy = GetParam();
        policy.buffer_policy = where;
        const Samples sample(100, 1.5);
        Samples got = sample;
        OutputPort<Samples> out("out"), other("other");
        InputPort<Samples> in("in");
        out.setDataSample(sample);
        other.setDataSample(sample);
        ASSERT_TRUE(out.createConnection(in, policy)) << where;
        if (where == PerInputPort) {
            ASSERT_TRUE(other.createConnection(in, policy));
        }
        expectRealTime(
            [&] {
                for (int i = 0; i < 50; ++i) {
                    (void)out.write(sample);
                    (void)other.write(sample);
                    for (int n = 0; n < i % 4; ++n) (void)in.read(got);
                }
            },
            forbidden(policy));
    }
}

TEST_P(RealTimePath, WithStorageAtTheWriterIsClean) {
    ConnPolicy policy = GetParam();
    policy.pull = true;
    policy.init = true;
    policy.mandatory = false;
    trafficOver(policy, Samples(100, 1.5));
}

TEST_P(RealTimePath, WithSeveralWritersIsClean) {
    const Samples sample(100, 1.5);
    Samples got = sample;
    std::vector<std::unique_ptr<OutputPort<Samples>>> outs;
    InputPort<Samples> in("in");
    for (int i = 0; i < 5; ++i) {
        outs.emplace_back(new OutputPort<Samples>("out"));
        outs.back()->setDataSample(sample);
        ASSERT_TRUE(outs.back()->createConnection(in, GetParam()));
    }
    expectRealTime(
        [&] {
            for (int i = 0; i < 100; ++i) {
                (void)outs[static_cast<std::size_t>(i * 7) % 5]->write(sample);
                if (i % 3 == 0) (void)in.read(got);
            }
            (void)in.readNewest(got);
            in.clear();
        },
        forbidden(GetParam()));
}

// In the writer's thread and, when the component's step calls back and reads, in that of the reader.
TEST_P(RealTimePath, OfEventPortsIsClean) {
    TaskContext component("component");
    ASSERT_TRUE(component.setActivity(new extras::SlaveActivity()));
    const Samples sample(100, 1.5);
    Samples got = sample;
    int called = 0;
    OutputPort<Samples> out("out");
    InputPort<Samples> in("in"), silent("silent");
    component.ports()->addEventPort(in, [&](base::PortInterface*) { called += in.read(got) == NewData; });
    component.ports()->addEventPort(silent);
    out.setDataSample(sample);
    ASSERT_TRUE(out.createConnection(in, GetParam()));
    ASSERT_TRUE(out.createConnection(silent, GetParam()));
    ASSERT_TRUE(component.start());
    (void)out.write(sample);
    ASSERT_TRUE(component.update());
    expectRealTime(
        [&] {
            for (int i = 0; i < 20; ++i) {
                (void)out.write(sample);
                if (i % 2) component.update();
            }
        },
        forbidden(GetParam()));
    EXPECT_GE(called, 10);
    component.stop();
}

// As scripts do.
TEST_P(RealTimePath, ThroughDataSourcesIsClean) {
    const Samples sample(100, 1.5);
    OutputPort<Samples> out("out");
    InputPort<Samples> in("in");
    out.setDataSample(sample);
    ASSERT_TRUE(out.createConnection(in, GetParam()));
    base::DataSourceBase::shared_ptr from(new internal::ValueDataSource<Samples>(sample));
    base::DataSourceBase::shared_ptr to(new internal::ValueDataSource<Samples>(sample));
    EXPECT_EQ(out.write(from), WriteSuccess);
    EXPECT_EQ(in.read(to), NewData);
    expectRealTime(
        [&] {
            for (int i = 0; i < 20; ++i) {
                (void)out.write(from);
                (void)in.read(to);
            }
        },
        forbidden(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(AllStorages, RealTimePath,
                         testing::Values(ConnPolicy::data(), ConnPolicy::data(ConnPolicy::LOCKED),
                                         ConnPolicy::data(ConnPolicy::UNSYNC), ConnPolicy::buffer(4),
                                         ConnPolicy::buffer(4, ConnPolicy::LOCKED),
                                         ConnPolicy::buffer(4, ConnPolicy::UNSYNC), ConnPolicy::circularBuffer(4),
                                         ConnPolicy::circularBuffer(4, ConnPolicy::LOCKED),
                                         ConnPolicy::circularBuffer(4, ConnPolicy::UNSYNC)));

TEST(RealTimePathAlone, WithoutAConnectionIsClean) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    const Samples sample(100, 1.5);
    Samples got = sample;
    OutputPort<Samples> out("out");
    InputPort<Samples> in("in");
    out.setDataSample(sample);
    expectRealTime([&] {
        EXPECT_EQ(out.write(sample), NotConnected);
        EXPECT_EQ(in.read(got), NoData);
        EXPECT_EQ(in.readNewest(got), NoData);
        in.clear();
        EXPECT_TRUE(out.keepsLastWrittenValue());
        EXPECT_FALSE(in.connected());
    });
}

TEST(RealTimePathAlone, TheTrapSeesASampleLargerThanAnnounced) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    OutputPort<Samples> out("out");
    InputPort<Samples> in("in");
    out.setDataSample(Samples(100));
    ASSERT_TRUE(out.createConnection(in));
    const Samples larger(101);
    RealTimeTrap trap;
    (void)out.write(larger);
    trap.stop();
    trap.forgive();
    EXPECT_GT(trap.caught(RealTimeTrap::kAllocation), 0u);
    EXPECT_EQ(trap.caught(RealTimeTrap::kLock | RealTimeTrap::kWait), 0u);
}

TEST(RealTimePathAlone, StorageIsSizedByTheDataSampleAlsoIfSmallerSamplesWereWritten) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    const Samples large(1000, 1.5), small(1);
    Samples got = large;
    OutputPort<Samples> out("out");
    InputPort<Samples> in("in");
    out.setDataSample(large);
    (void)out.write(small);
    ASSERT_TRUE(out.createConnection(in, ConnPolicy::buffer(4)));
    expectRealTime([&] {
        for (int i = 0; i < 10; ++i) {
            (void)out.write(large);
            (void)in.read(got);
        }
    });
}
