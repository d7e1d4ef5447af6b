// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Channel elements as transports write them.
#include "log_capture.hpp"

#include <rtt/Port.hpp>
#include <rtt/base/ChannelElement.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <gtest/gtest.h>

#include <vector>

using namespace RTT;

namespace {

int alive = 0;

/** Sends, that is collects, what it is told to. */
template <class T>
class Sender : public base::ChannelElement<T> {
public:
    typedef typename base::ChannelElement<T>::param_t param_t;
    Sender() { ++alive; }
    ~Sender() override { --alive; }
    WriteStatus write(param_t sample) override {
        if (broken) return NotConnected;
        sent.push_back(sample);
        return WriteSuccess;
    }
    WriteStatus data_sample(param_t sample, bool) override {
        size = sample;
        return WriteSuccess;
    }
    /** A transport's thread would do this after signal(). */
    bool signal() override {
        typename base::ChannelElement<T>::shared_ptr input = this->getInput();
        typename base::ChannelElement<T>::value_t sample = T();
        while (input && input->read(sample, false) == NewData) write(sample);
        return true;
    }
    bool inputReady() override { return true; }
    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return "test:" + std::to_string(sent.size()); }
    void disconnect(bool forward) override {
        ++closed;
        base::ChannelElement<T>::disconnect(forward);
    }

    std::vector<T> sent;
    T size = T();
    bool broken = false;
    int closed = 0;
};

/** Has a new sample whenever it is asked. */
struct Spring : base::ChannelElement<int> {
    FlowStatus read(int& sample, bool) override {
        sample = ++last;
        return NewData;
    }
    int last = 0;
};

}  // namespace

TEST(ChannelElement, ThatAlwaysHasSomethingNewDoesNotKeepItsReader) {
    InputPort<int> in("in");
    boost::intrusive_ptr<Spring> spring(new Spring());
    ASSERT_TRUE(in.channelReady(spring, ConnPolicy(), new internal::StreamConnID("spring")));
    int got = 0;
    EXPECT_EQ(in.readNewest(got), NewData);
    EXPECT_EQ(got, spring->last);
}

TEST(ChannelElement, SendsThroughABufferInFrontOfIt) {
    OutputPort<int> out("out");
    out.setDataSample(17);
    boost::intrusive_ptr<Sender<int>> sender(new Sender<int>);
    base::ChannelElementBase::shared_ptr buffer = internal::ConnFactory::buildDataStorage<int>(ConnPolicy::buffer(4));
    ASSERT_TRUE(buffer);
    EXPECT_TRUE(buffer->connectTo(sender));
    EXPECT_TRUE(out.addConnection(new internal::StreamConnID("topic"), buffer, ConnPolicy::buffer(4)));
    EXPECT_EQ(sender->size, 17);
    EXPECT_EQ(out.write(1), WriteSuccess);
    EXPECT_EQ(out.write(2), WriteSuccess);
    EXPECT_EQ(sender->sent, (std::vector<int>{1, 2}));
    EXPECT_EQ(buffer->getRemoteURI(), "test:2");  // passed on
    EXPECT_EQ(sender->getInputEndPoint()->getPort(), &out);
    out.disconnect();
    EXPECT_EQ(sender->closed, 1);
    EXPECT_FALSE(sender->getInput());
}

TEST(ChannelElement, SendsWithoutBuffer) {
    OutputPort<int> out("out");
    boost::intrusive_ptr<Sender<int>> sender(new Sender<int>);
    out.write(5);
    ConnPolicy policy(ConnPolicy::UNBUFFERED);
    policy.init = true;
    EXPECT_TRUE(out.addConnection(new internal::StreamConnID("topic"), sender, policy));
    out.write(6);
    EXPECT_EQ(sender->sent, (std::vector<int>{5, 6}));
    internal::StreamConnID id("topic");
    EXPECT_TRUE(out.removeConnection(&id));
    EXPECT_FALSE(out.connected());
}

TEST(ChannelElement, ThatIsBrokenIsRemovedByTheNextWrite) {
    flow_test::LogCapture log;
    OutputPort<int> out("out");
    InputPort<int> in("in");
    boost::intrusive_ptr<Sender<int>> sender(new Sender<int>);
    out.addConnection(new internal::StreamConnID("topic"), sender, ConnPolicy());
    out.connectTo(&in);
    sender->broken = true;
    EXPECT_EQ(out.write(1), NotConnected);
    EXPECT_EQ(out.write(2), WriteSuccess);
    EXPECT_EQ(sender->closed, 1);
    in.disconnect();
    sender->broken = false;
    out.addConnection(new internal::StreamConnID("topic"), sender, ConnPolicy());
    sender->broken = true;
    EXPECT_EQ(out.write(3), NotConnected);
    EXPECT_FALSE(out.connected());
    EXPECT_TRUE(log.contains("its last channel was found broken during write()")) << log.text();
}

TEST(ChannelElement, ThatAreBrokenAreAllRemovedByTheNextWrite) {
    OutputPort<int> out("out");
    InputPort<int> in("in");
    out.connectTo(&in);
    boost::intrusive_ptr<Sender<int>> senders[3];
    for (auto& sender : senders) {
        sender.reset(new Sender<int>);
        out.addConnection(new internal::StreamConnID("topic"), sender, ConnPolicy());
    }
    for (auto& sender : senders) sender->broken = true;
    EXPECT_EQ(out.write(1), NotConnected);
    EXPECT_EQ(out.getManager()->getChannels().size(), 1u);
    EXPECT_EQ(out.write(2), WriteSuccess);
    for (auto& sender : senders) EXPECT_EQ(sender->closed, 1);
}

TEST(ChannelElement, ReceivesIntoTheStorageOfAnInputPort) {
    InputPort<int> in("in");
    boost::intrusive_ptr<base::ChannelElement<int>> receiver(new Sender<int>);
    base::ChannelElementBase::shared_ptr storage = internal::ConnFactory::makeChannelOutput(in, ConnPolicy::buffer(4));
    ASSERT_TRUE(storage);
    receiver->connectTo(storage);
    EXPECT_TRUE(in.channelReady(storage, ConnPolicy::buffer(4), new internal::StreamConnID("topic")));
    ASSERT_TRUE(receiver->getOutput());
    EXPECT_EQ(receiver->getOutput()->write(3), WriteSuccess);
    int got = 0;
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, 3);
    receiver->disconnect(true);  // the transport closes the stream
    EXPECT_FALSE(in.connected());
    EXPECT_FALSE(receiver->getOutput());
}

TEST(ChannelElement, OfAnotherTypeIsNoNeighbour) {
    boost::intrusive_ptr<Sender<int>> ints(new Sender<int>);
    boost::intrusive_ptr<Sender<double>> doubles(new Sender<double>);
    ints->connectTo(doubles);
    EXPECT_FALSE(ints->getOutput());
    EXPECT_TRUE(static_cast<base::ChannelElementBase&>(*ints).getOutput());
    ints->disconnect(true);
}

TEST(ChannelElement, IsDestroyedWithItsConnection) {
    internal::Reclaimer::collect();  // what earlier tests left
    const int before = alive;
    {
        OutputPort<int> out("out");
        out.addConnection(new internal::StreamConnID("topic"), new Sender<int>, ConnPolicy());
        EXPECT_EQ(alive, before + 1);
        out.disconnect();
        EXPECT_EQ(alive, before);
    }
}
