// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A transport as packages write them: elements that publish and receive, storage before the sender and behind the receiver,
// and a service that draws what is connected.
#include <rtt/TaskContext.hpp>
#include <rtt/Port.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/types/TransportPlugin.hpp>
#include <rtt/types/TypeTransporter.hpp>
#include <rtt/types/TypekitPlugin.hpp>

#include <gtest/gtest.h>

#define ORO_BUS_PROTOCOL_ID 88

using namespace RTT;

namespace {

/** The world outside: the last receiver of each topic. */
template <typename T>
struct Bus {
    static std::map<std::string, base::ChannelElement<T>*>& receivers() {
        static std::map<std::string, base::ChannelElement<T>*> all;
        return all;
    }
};

template <typename T>
class BusPublisher : public RTT::base::ChannelElement<T> {
    std::string topic, owner;
    typename RTT::base::ChannelElement<T>::value_t sample;

public:
    BusPublisher(base::PortInterface* port, const ConnPolicy& policy) : topic(policy.name_id), sample() {
        if (port->getInterface() && port->getInterface()->getOwner())
            owner = port->getInterface()->getOwner()->getName();
        else
            owner = "nobody";
    }
    virtual bool inputReady() { return true; }
#if RTT_VERSION_GTE(2, 8, 99)
    virtual WriteStatus data_sample(typename base::ChannelElement<T>::param_t s) {
        this->sample = s;
        return WriteSuccess;
    }
#else
#error "the runtime must report the data flow of version 2.9"
#endif
    bool signal() {
        typename base::ChannelElement<T>::shared_ptr input =
            boost::dynamic_pointer_cast<base::ChannelElement<T>>(this->getInput());
        while (input && (input->read(sample, false) == NewData)) this->write(sample);
        return true;
    }
    virtual WriteStatus write(typename base::ChannelElement<T>::param_t s) {
        if (!Bus<T>::receivers().count(topic)) return WriteFailure;
        Bus<T>::receivers()[topic]->write(s);
        return WriteSuccess;
    }
    virtual bool isRemoteElement() const { return true; }
    virtual std::string getElementName() const { return "BusPublisher of " + owner; }
    virtual std::string getRemoteURI() const { return topic; }
};

template <typename T>
class BusReceiver : public RTT::base::ChannelElement<T> {
    std::string topic;

public:
    BusReceiver(base::PortInterface*, const ConnPolicy& policy) : topic(policy.name_id) {
        Bus<T>::receivers()[topic] = this;
    }
    ~BusReceiver() { Bus<T>::receivers().erase(topic); }
    virtual bool inputReady() { return true; }
    virtual WriteStatus write(typename base::ChannelElement<T>::param_t s) {
        typename base::ChannelElement<T>::shared_ptr output = this->getOutput();
        return output ? output->write(s) : NotConnected;
    }
    virtual bool isRemoteElement() const { return true; }
    virtual std::string getElementName() const { return "BusReceiver"; }
};

template <class T>
class BusTransporter : public RTT::types::TypeTransporter {
    virtual base::ChannelElementBase::shared_ptr createStream(base::PortInterface* port, const ConnPolicy& policy,
                                                              bool is_sender) const {
        base::ChannelElementBase::shared_ptr channel;
        if (policy.pull) {
            RTT::log(RTT::Error) << "Pull connections are not supported by the bus." << RTT::endlog();
            return base::ChannelElementBase::shared_ptr();
        }
        if (is_sender) {
            channel = new BusPublisher<T>(port, policy);
            if (policy.type == ConnPolicy::UNBUFFERED) return channel;
            base::ChannelElementBase::shared_ptr buf = internal::ConnFactory::buildDataStorage<T>(policy);
            if (!buf) return base::ChannelElementBase::shared_ptr();
            buf->connectTo(channel);
            return buf;
        }
        channel = new BusReceiver<T>(port, policy);
        base::ChannelElementBase::shared_ptr buf = internal::ConnFactory::buildDataStorage<T>(policy);
        if (!buf) return base::ChannelElementBase::shared_ptr();
        channel->connectTo(buf);
        return channel;
    }
};

struct BusPlugin : public RTT::types::TransportPlugin {
    bool registerTransport(std::string name, types::TypeInfo* ti) {
        if (name == "double") return ti->addProtocol(ORO_BUS_PROTOCOL_ID, new BusTransporter<double>());
        return false;
    }
    std::string getTransportName() const { return "bus"; }
    std::string getTypekitName() const { return "rtt-types"; }
    std::string getName() const { return "rtt-bus-transport"; }
};

ConnPolicy topic(const std::string& name) {
    ConnPolicy policy = ConnPolicy::buffer(10);
    policy.transport = ORO_BUS_PROTOCOL_ID;
    policy.name_id = name;
    return policy;
}

/** Once per process. */
bool loadBus() {
    types::TypekitRepository::Import(new BusPlugin());
    return types::TypekitRepository::hasTransport("rtt-bus-transport");
}

}  // namespace

TEST(UserCode, SendsSamplesOverItsTransport) {
    ASSERT_TRUE(loadBus());
    TaskContext sender("sender");
    OutputPort<double> out("out");
    InputPort<double> in("in");
    sender.addPort(out);
    ASSERT_TRUE(in.createStream(topic("/x")));
    ASSERT_TRUE(out.createStream(topic("/x")));
    EXPECT_TRUE(out.connected() && in.connected());
    EXPECT_EQ(out.write(1.0), WriteSuccess);
    EXPECT_EQ(out.write(2.0), WriteSuccess);
    double value = 0.0;
    EXPECT_EQ(in.read(value), NewData);
    EXPECT_EQ(value, 1.0);
    EXPECT_EQ(in.read(value), NewData);
    EXPECT_EQ(value, 2.0);
    EXPECT_EQ(in.read(value), OldData);
}

TEST(UserCode, SendsSamplesWithoutStorage) {
    ASSERT_TRUE(loadBus());
    OutputPort<double> out("out");
    InputPort<double> in("in");
    ASSERT_TRUE(in.createStream(topic("/y")));
    ConnPolicy policy = topic("/y");
    policy.type = ConnPolicy::UNBUFFERED;
    ASSERT_TRUE(out.createStream(policy));
    EXPECT_EQ(out.write(3.0), WriteSuccess);
    double value = 0.0;
    EXPECT_EQ(in.read(value), NewData);
    EXPECT_EQ(value, 3.0);
}

TEST(UserCode, RefusesWhatTheTransportCannotDo) {
    ASSERT_TRUE(loadBus());
    ConnPolicy policy = topic("/z");
    policy.pull = ConnPolicy::PULL;
    OutputPort<double> out("out");
    EXPECT_FALSE(out.createStream(policy));
    OutputPort<std::string> text("text");
    EXPECT_FALSE(text.createStream(topic("/z"))) << "the transport has no transporter for strings";
    EXPECT_FALSE(out.connected() || text.connected());
}

TEST(UserCode, DrawsTheConnectionsOfAComponent) {
    ASSERT_TRUE(loadBus());
    TaskContext left("left"), right("right");
    OutputPort<double> out("out");
    InputPort<double> in("in");
    left.addPort(out);
    right.addPort(in);
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(out.createStream(topic("/w")));
    std::string drawn;
    std::list<internal::ConnectionManager::ChannelDescriptor> channels = out.getManager()->getChannels();
    for (std::list<internal::ConnectionManager::ChannelDescriptor>::iterator it = channels.begin();
         it != channels.end(); ++it) {
        base::ChannelElementBase::shared_ptr element = it->get<1>();
        ConnPolicy policy = it->get<2>();
        base::ChannelElementBase::shared_ptr from = element->getInputEndPoint();
        base::ChannelElementBase::shared_ptr to = element->getOutputEndPoint();
        if (to->getPort() && to->getPort()->getInterface())
            drawn += from->getPort()->getInterface()->getOwner()->getName() + "->" +
                     to->getPort()->getInterface()->getOwner()->getName() + ";";
        else
            drawn += element->getInputEndPoint()->getPort()->getName() + "->" + policy.name_id + ";";
    }
    EXPECT_EQ(drawn, "left->right;out->/w;");
    channels = in.getManager()->getConnections();
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels.front().get<1>()->getInputEndPoint()->getPort()->getInterface()->getOwner(), &left);
}
