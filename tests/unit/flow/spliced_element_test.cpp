// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Elements of users in the middle of a channel between two ports.
#include <rtt/Port.hpp>
#include <rtt/base/ChannelElement.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/internal/ConnectionManager.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

/** Doubles what is written through it, and adds one to what is read through it. */
class Filter : public base::ChannelElement<int> {
public:
    WriteStatus write(param_t sample) override {
        ++writes;
        return base::ChannelElement<int>::write(2 * sample);
    }
    FlowStatus read(reference_t sample, bool copy_old_data) override {
        const FlowStatus status = base::ChannelElement<int>::read(sample, copy_old_data);
        if (status == NewData || (status == OldData && copy_old_data)) ++sample;
        return status;
    }
    bool signal() override {
        ++signals;
        return base::ChannelElement<int>::signal();
    }
    void clear() override {
        ++clears;
        base::ChannelElement<int>::clear();
    }
    int writes = 0, signals = 0, clears = 0;
};

struct Spliced : testing::TestWithParam<bool> {
    bool atReader() const { return GetParam(); }
    /** out -> filter -> storage -> in, or out -> storage -> filter -> in. */
    void connect(const ConnPolicy& policy) {
        const auto storage = internal::ConnFactory::buildDataStorage<int>(policy);
        ASSERT_TRUE(storage);
        const base::ChannelElementBase::shared_ptr first = atReader() ? storage : filter,
                                                   last = atReader() ? filter : storage;
        ASSERT_TRUE(first->connectTo(last));
        ASSERT_TRUE(last->connectTo(in.getEndpoint()));
        ASSERT_TRUE(in.channelReady(last, policy, new internal::StreamConnID("spliced")));
        ASSERT_TRUE(out.addConnection(new internal::StreamConnID("spliced"), first, policy));
    }
    int through(int value) const { return atReader() ? value + 1 : 2 * value; }

    OutputPort<int> out{"out"};
    InputPort<int> in{"in"};
    boost::intrusive_ptr<Filter> filter{new Filter};
    int got = 0;
};

}  // namespace

TEST_P(Spliced, TakesPartInWritingReadingAndSignalling) {
    out.setDataSample(9);
    connect(ConnPolicy::buffer(3));
    EXPECT_EQ(in.read(got), NoData);
    EXPECT_EQ(out.write(4), WriteSuccess);
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, through(4));
    got = 0;
    EXPECT_EQ(in.read(got, false), OldData);
    EXPECT_EQ(got, 0);
    EXPECT_EQ(in.read(got), OldData);
    EXPECT_EQ(got, through(4));
    EXPECT_EQ(filter->writes, atReader() ? 0 : 1);
    EXPECT_EQ(filter->signals, atReader() ? 1 : 0);
    in.clear();
    EXPECT_EQ(in.read(got), NoData);
    EXPECT_EQ(filter->clears, atReader() ? 1 : 0);
}

TEST_P(Spliced, StartsWithTheLastValueIfThePolicySaysSo) {
    out.write(5);
    connect(ConnPolicy::data());
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, through(5));
}

TEST_P(Spliced, LeadsFromEitherEndToTheOther) {
    connect(ConnPolicy::data());
    EXPECT_EQ(filter->getInputEndPoint()->getPort(), &out);
    EXPECT_EQ(filter->getOutputEndPoint()->getPort(), &in);
    EXPECT_EQ(out.getManager()->getChannels().front().get<1>()->getOutputEndPoint()->getPort(), &in);
}

TEST_P(Spliced, IsTakenApartFromEitherEnd) {
    for (const bool fromReader : {false, true}) {
        connect(ConnPolicy::data());
        if (fromReader)
            in.disconnect();
        else
            out.disconnect();
        EXPECT_FALSE(out.connected() || in.connected());
        EXPECT_FALSE(filter->getInput() || filter->getOutput());
        EXPECT_EQ(out.write(1), NotConnected);
    }
}

TEST_P(Spliced, IsTakenApartByItselfToo) {
    connect(ConnPolicy::data());
    filter->disconnect(true);
    EXPECT_FALSE(in.connected());
    filter->disconnect(false);
    (void)out.write(1);  // finds it broken at the latest
    out.disconnect();
    EXPECT_FALSE(out.connected());
}

TEST_P(Spliced, EndsWithAPortThatDies) {
    {
        InputPort<int> dying("dying");
        const auto storage = internal::ConnFactory::buildDataStorage<int>(ConnPolicy::data());
        filter->connectTo(storage);
        storage->connectTo(dying.getEndpoint());
        dying.channelReady(storage, ConnPolicy::data(), new internal::StreamConnID("spliced"));
        out.addConnection(new internal::StreamConnID("spliced"), filter, ConnPolicy::data());
    }
    EXPECT_FALSE(out.connected());
    EXPECT_EQ(out.write(1), NotConnected);
}

INSTANTIATE_TEST_SUITE_P(AtBothEnds, Spliced, testing::Values(false, true),
                         [](const auto& info) { return info.param ? "BesideTheReader" : "BesideTheWriter"; });
