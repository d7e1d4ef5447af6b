// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Elements of transports, with either form of data_sample().
#include <rtt/Port.hpp>
#include <rtt/base/ChannelElement.hpp>
#include <rtt/internal/ConnID.hpp>

#include <gtest/gtest.h>

namespace {

typedef std::vector<double> Samples;

struct Publisher : RTT::base::ChannelElement<Samples> {
    std::size_t size = 0;
    virtual RTT::WriteStatus write(param_t) { return RTT::WriteSuccess; }
    virtual RTT::WriteStatus data_sample(param_t sample) {
        size = sample.size();
        return RTT::WriteSuccess;
    }
};

struct NewPublisher : RTT::base::ChannelElement<Samples> {
    std::size_t size = 0;
    bool reset = false;
    virtual RTT::WriteStatus data_sample(param_t sample, bool again = true) {
        size = sample.size();
        reset = again;
        return RTT::WriteSuccess;
    }
};

}  // namespace

TEST(UserCode, IsToldTheSampleByTheShortForm) {
    RTT::OutputPort<Samples> out("out");
    Publisher* const element = new Publisher();
    const RTT::base::ChannelElementBase::shared_ptr channel(element);
    out.setDataSample(Samples(6));
    ASSERT_TRUE(out.addConnection(new RTT::internal::StreamConnID("topic"), channel, RTT::ConnPolicy()));
    EXPECT_EQ(element->size, 6u);
    out.setDataSample(Samples(7));
    EXPECT_EQ(element->size, 7u);
}

TEST(UserCode, IsToldTheSampleByTheLongForm) {
    RTT::OutputPort<Samples> out("out");
    NewPublisher* const element = new NewPublisher();
    const RTT::base::ChannelElement<Samples>::shared_ptr channel(element);
    out.setDataSample(Samples(6));
    ASSERT_TRUE(out.addConnection(new RTT::internal::StreamConnID("topic"), channel, RTT::ConnPolicy()));
    EXPECT_EQ(element->size, 6u);
    EXPECT_FALSE(element->reset);
    EXPECT_EQ(channel->data_sample(Samples(8)), RTT::WriteSuccess);
    EXPECT_EQ(element->size, 8u);
    EXPECT_TRUE(element->reset);
}

namespace {
// Apart: GCC 12 guesses that a call of it might reach one of the classes above, and warns that the object is too small.
[[gnu::noinline]] RTT::base::ChannelElement<Samples>::shared_ptr plainElement() {
    return new RTT::base::ChannelElement<Samples>();
}
}  // namespace

// An element that does nothing passes both on.
TEST(UserCode, PassesTheSampleOn) {
    const RTT::base::ChannelElement<Samples>::shared_ptr first = plainElement();
    Publisher* const last = new Publisher();
    ASSERT_TRUE(first->connectTo(RTT::base::ChannelElementBase::shared_ptr(last)));
    EXPECT_EQ(first->data_sample(Samples(5)), RTT::WriteSuccess);
    EXPECT_EQ(last->size, 5u);
    EXPECT_EQ(first->data_sample(Samples(6), false), RTT::WriteSuccess);
    EXPECT_EQ(last->size, 6u);
    first->disconnect(true);  // neighbours hold each other
}

TEST(UserCode, IsRefusedAConnectionOfNothing) {
    RTT::OutputPort<Samples> out("out");
    EXPECT_FALSE(out.addConnection(0, new Publisher(), RTT::ConnPolicy()));
    EXPECT_FALSE(out.addConnection(new RTT::internal::StreamConnID("topic"), 0, RTT::ConnPolicy()));
    EXPECT_FALSE(out.connected());
}
