// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Streams and out-of-band connections over a transport that this test brings along.
#include "log_capture.hpp"

#include <rtt/Port.hpp>
#include <rtt/base/ChannelElement.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt/types/TypeMarshaller.hpp>
#include <rtt/types/Types.hpp>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

using namespace RTT;
using flow_test::LogCapture;

namespace {

constexpr int kProtocol = 77;
struct Telegram {
    std::vector<int> words;
};

typedef boost::intrusive_ptr<base::ChannelElement<Telegram>> Element;
/** The receivers of each topic, and what a test wants to go wrong. */
std::map<std::string, std::vector<Element>> topics;
std::vector<std::string> created;
bool refuseSender = false, refuseReceiver = false, receiverNotReady = false;

class Receiver : public base::ChannelElement<Telegram> {
public:
    bool inputReady() override { return !receiverNotReady; }
    std::string getElementName() const override { return "Receiver"; }
};

class Sender : public base::ChannelElement<Telegram> {
public:
    explicit Sender(const std::string& topic) : topic_(topic) {}
    WriteStatus write(param_t sample) override {
        for (const Element& receiver : topics[topic_])
            if (const Element next = receiver->getOutput()) (void)next->write(sample);
        return WriteSuccess;
    }
    WriteStatus data_sample(param_t, bool) override { return WriteSuccess; }

private:
    std::string topic_;
};

class Transport : public types::TypeMarshaller {
public:
    base::ChannelElementBase::shared_ptr createStream(base::PortInterface*, const ConnPolicy& policy,
                                                      bool is_sender) const override {
        created.push_back(is_sender ? "sender" : "receiver");
        if (is_sender ? refuseSender : refuseReceiver) return nullptr;
        if (policy.name_id.empty()) policy.name_id = "topic" + std::to_string(topics.size());
        if (is_sender) return new Sender(policy.name_id);
        topics[policy.name_id].push_back(Element(new Receiver));
        return topics[policy.name_id].back();
    }
    std::pair<void const*, int> fillBlob(base::DataSourceBase::shared_ptr, void*, int, void*) const override {
        return {nullptr, 0};
    }
    bool updateFromBlob(const void*, int, base::DataSourceBase::shared_ptr, void*) const override { return false; }
    unsigned int getSampleSize(base::DataSourceBase::shared_ptr sample, void*) const override {
        const Telegram* telegram = static_cast<const Telegram*>(sample->getRawConstPointer());
        return telegram ? static_cast<unsigned int>(4 * telegram->words.size()) : 0;
    }
};

struct Streams : testing::Test {
    static void SetUpTestSuite() {
        if (types::Types()->type("Telegram")) return;
        types::Types()->addType(new types::TemplateTypeInfo<Telegram>("Telegram"));
        types::Types()->type("Telegram")->addProtocol(kProtocol, new Transport);
    }
    void SetUp() override { policy.transport = kProtocol; }
    void TearDown() override {
        out.disconnect();
        in.disconnect();
        topics.clear();
        created.clear();
        refuseSender = refuseReceiver = receiverNotReady = false;
    }
    static Telegram telegram(int word) {
        Telegram t;
        t.words.assign(1, word);
        return t;
    }
    OutputPort<Telegram> out{"out"};
    InputPort<Telegram> in{"in"};
    ConnPolicy policy = ConnPolicy::buffer(4);
    Telegram got;
};

}  // namespace

TEST_F(Streams, NeedATransport) {
    LogCapture log;
    EXPECT_FALSE(out.createStream(ConnPolicy()));
    EXPECT_FALSE(in.createStream(ConnPolicy()));
    EXPECT_TRUE(log.contains("output port out: need a transport for creating streams")) << log.text();
    EXPECT_TRUE(log.contains("input port in: need a transport for creating streams")) << log.text();
}

TEST_F(Streams, NeedATransportThatKnowsTheType) {
    LogCapture log;
    policy.transport = kProtocol + 1;
    EXPECT_FALSE(out.createStream(policy));
    EXPECT_TRUE(log.contains("could not create transport stream for output port out with transport id 78"))
        << log.text();
    EXPECT_TRUE(log.contains("no such transport registered")) << log.text();
    EXPECT_TRUE(log.contains("Telegram")) << log.text();
    struct Unknown {};
    InputPort<Unknown> unknown("unknown");
    EXPECT_FALSE(unknown.createStream(policy));
    EXPECT_FALSE(out.connected() || in.connected() || unknown.connected());
}

TEST_F(Streams, CarrySamplesBetweenPortsThatDoNotKnowEachOther) {
    ASSERT_TRUE(out.createStream(policy));
    EXPECT_EQ(policy.name_id, "topic0");
    ASSERT_TRUE(in.createStream(policy));
    EXPECT_TRUE(out.connected() && in.connected());
    EXPECT_FALSE(out.connectedTo(&in));
    EXPECT_EQ(out.write(telegram(5)), WriteSuccess);
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got.words, std::vector<int>{5});
    EXPECT_EQ(in.read(got), OldData);
}

TEST_F(Streams, AreRemovedByTheirName) {
    policy.name_id = "a";
    ASSERT_TRUE(out.createStream(policy));
    policy.name_id = "b";
    ASSERT_TRUE(out.createStream(policy));
    internal::StreamConnID id("a");
    EXPECT_TRUE(out.removeConnection(&id));
    EXPECT_FALSE(out.removeConnection(&id));
    EXPECT_TRUE(out.connected());
    EXPECT_EQ(out.getManager()->getChannels().front().get<2>().name_id, "b");
}

TEST_F(Streams, TellTheTransportTheSizeOfSamples) {
    Telegram large;
    large.words.resize(100);
    out.setDataSample(large);
    ASSERT_TRUE(out.createStream(policy));
    EXPECT_EQ(policy.data_size, 400);
    (void)out.write(telegram(1));  // smaller
    policy.name_id = "second";
    ASSERT_TRUE(out.createStream(policy));
    EXPECT_EQ(policy.data_size, 400);
    OutputPort<Telegram> other("other");
    large.words.resize(200);
    (void)other.write(large);
    ASSERT_TRUE(other.createStream(policy));
    EXPECT_EQ(policy.data_size, 800);  // the last value, if setDataSample() was not called
}

TEST_F(Streams, ThatTheTransportRefusesLeaveNothingBehind) {
    LogCapture log;
    refuseSender = refuseReceiver = true;
    EXPECT_FALSE(out.createStream(policy));
    EXPECT_FALSE(in.createStream(policy));
    EXPECT_TRUE(log.contains("transport 77 failed to create a remote channel for output port out")) << log.text();
    refuseReceiver = false;
    receiverNotReady = true;
    EXPECT_FALSE(in.createStream(policy));
    EXPECT_TRUE(log.contains("input port in could not read from the stream")) << log.text();
    EXPECT_FALSE(out.connected() || in.connected());
}

TEST_F(Streams, BetweenTwoLocalPortsAreMadeFromTheSendersEnd) {
    ASSERT_TRUE(out.connectTo(&in, policy));
    EXPECT_EQ(created, (std::vector<std::string>{"sender", "receiver"}));
    EXPECT_TRUE(out.connected() && in.connected());
    out.write(telegram(6));
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got.words, std::vector<int>{6});
    EXPECT_EQ(policy.name_id, "");  // a second pair of ports must not join this one's topic
}

TEST_F(Streams, BetweenTwoLocalPortsLeaveNothingBehindIfOneEndFails) {
    LogCapture log;
    receiverNotReady = true;
    EXPECT_FALSE(out.connectTo(&in, policy));
    EXPECT_FALSE(out.connected() || in.connected());
    receiverNotReady = false;
    refuseSender = true;
    EXPECT_FALSE(in.connectTo(&out, policy));
    EXPECT_FALSE(out.connected() || in.connected());
}

TEST_F(Streams, HaveStorageOfTheirOwnBesideTheSharedOneOfAPort) {
    policy.buffer_policy = PerInputPort;
    ASSERT_TRUE(in.createStream(policy));
    ConnPolicy local = ConnPolicy::buffer(4);
    local.buffer_policy = PerInputPort;
    ASSERT_TRUE(out.createConnection(in, local));
    internal::StreamConnID id(policy.name_id);
    EXPECT_TRUE(in.removeConnection(&id));
    in.signalInterface(true);
    EXPECT_EQ(out.write(telegram(7)), WriteSuccess);
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_TRUE(in.getManager()->getChannels().front().get<1>()->signal());  // the way to the port is whole

    policy.buffer_policy = PerOutputPort;
    OutputPort<Telegram> second("second");
    InputPort<Telegram> reader("reader");
    ASSERT_TRUE(second.createStream(policy));
    local.buffer_policy = PerOutputPort;
    ASSERT_TRUE(second.createConnection(reader, local));
    second.write(telegram(8));
    EXPECT_EQ(reader.read(got), NewData);
    EXPECT_EQ(got.words, std::vector<int>{8});
}
