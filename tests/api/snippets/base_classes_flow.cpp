// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports and elements of transports that users write.
#include <rtt/DataFlowInterface.hpp>
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/ChannelElement.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnFactory.hpp>

#include <boost/scoped_ptr.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

/** Everything that an element of a channel can override. */
class Topic : public RTT::base::ChannelElement<double> {
public:
    double last = 0.0, sample = 0.0;
    bool cleared = false, gone = false;
    int signals = 0;

    WriteStatus write(param_t value) override {
        last = value;
        return WriteSuccess;
    }
    FlowStatus read(reference_t value, bool copy_old_data = true) override {
        if (copy_old_data) value = last;
        return OldData;
    }
    WriteStatus data_sample(param_t value) override {
        sample = value;
        return WriteSuccess;
    }
    value_t data_sample() override { return sample; }
    bool signal() override { return ++signals > 0; }
    bool inputReady() override { return true; }
    bool channelReady(base::ChannelElementBase::shared_ptr const&, ConnPolicy const&, internal::ConnID* = 0) override {
        return true;
    }
    void clear() override { cleared = true; }
    void disconnect(bool forward) override {
        gone = true;
        base::ChannelElement<double>::disconnect(forward);
    }
    bool isRemoteElement() const override { return true; }
    std::string getElementName() const override { return "Topic"; }
    std::string getRemoteURI() const override { return "topic://x"; }
    std::string getLocalURI() const override { return "topic://here"; }
};

/** The input port of another process, as a transport shows it. */
class RemoteInput : public RTT::base::InputPortInterface {
public:
    RemoteInput(const std::string& name) : InputPortInterface(name, ConnPolicy()), cleared(false) {}
    ~RemoteInput() override { closeDown(); }
    const types::TypeInfo* getTypeInfo() const override { return internal::DataSourceTypeInfo<double>::getTypeInfo(); }
    int serverProtocol() const override { return 77; }
    bool isLocal() const override { return false; }
    bool connected() const override { return false; }
    void disconnect() override {}
    bool disconnect(base::PortInterface*) override { return false; }
    bool createStream(ConnPolicy const&) override { return false; }
    base::PortInterface* clone() const override { return new RemoteInput(getName()); }
    base::PortInterface* antiClone() const override { return new OutputPort<double>(getName()); }
    base::DataSourceBase* getDataSource() override { return 0; }
    FlowStatus read(base::DataSourceBase::shared_ptr, bool = true) override { return NoData; }
    void clear() override { cleared = true; }
    bool removeConnection(internal::ConnID* id) override { return InputPortInterface::removeConnection(id); }
    bool cleared;
};

class RemoteOutput : public RTT::base::OutputPortInterface {
public:
    RemoteOutput(const std::string& name) : OutputPortInterface(name) {}
    ~RemoteOutput() override { closeDown(); }
    const types::TypeInfo* getTypeInfo() const override { return internal::DataSourceTypeInfo<double>::getTypeInfo(); }
    int serverProtocol() const override { return 77; }
    bool isLocal() const override { return false; }
    bool connected() const override { return true; }
    void disconnect() override {}
    bool disconnect(base::PortInterface*) override { return true; }
    bool createStream(ConnPolicy const&) override { return false; }
    bool createConnection(base::InputPortInterface&, ConnPolicy const&) override { return true; }
    using base::OutputPortInterface::createConnection;
    base::PortInterface* clone() const override { return new RemoteOutput(getName()); }
    base::PortInterface* antiClone() const override { return new InputPort<double>(getName()); }
    base::DataSourceBase* getDataSource() const override { return 0; }
    WriteStatus write(base::DataSourceBase::shared_ptr) override { return WriteSuccess; }
};

struct LatchedPolicy : public RTT::ConnPolicy {
    LatchedPolicy() : ConnPolicy(ConnPolicy::data(ConnPolicy::LOCK_FREE, true)) { name_id = "latched"; }
};

struct CountedPorts : public RTT::DataFlowInterface {
    int added = 0;
    base::PortInterface& add(base::PortInterface& port) {
        ++added;
        return addLocalPort(port);
    }
};

}  // namespace

TEST(UserCode, DerivesAChannelElement) {
    OutputPort<double> out("out");
    Topic* const topic = new Topic();
    const base::ChannelElementBase::shared_ptr held(topic);
    out.setDataSample(1.0);
    ASSERT_TRUE(out.addConnection(new internal::StreamConnID("x"), held, ConnPolicy()));
    EXPECT_EQ(topic->sample, 1.0);
    EXPECT_EQ(out.write(2.0), WriteSuccess);
    EXPECT_EQ(topic->last, 2.0);
    const internal::ConnectionManager::Connections connections = out.getManager()->getConnections();
    ASSERT_EQ(connections.size(), 1u);
    EXPECT_EQ(connections.front().get<1>()->getElementName(), "Topic");
    EXPECT_TRUE(connections.front().get<1>()->isRemoteElement());
    out.disconnect();
    EXPECT_TRUE(topic->gone);
}

TEST(UserCode, ReadsFromAnElementOfItsOwn) {
    InputPort<double> in("in");
    Topic* const topic = new Topic();
    const base::ChannelElementBase::shared_ptr held(topic);
    topic->last = 3.0;
    ASSERT_TRUE(in.channelReady(held, ConnPolicy(), new internal::StreamConnID("x")));
    double value = 0.0;
    EXPECT_EQ(in.read(value), OldData);
    EXPECT_EQ(value, 3.0);
    in.clear();
    EXPECT_TRUE(topic->cleared);

    Topic* const last = new Topic();
    const base::ChannelElement<double>::shared_ptr first(new base::ChannelElement<double>());
    first->setOutput(base::ChannelElementBase::shared_ptr(last));
    EXPECT_EQ(first->getOutput().get(), last);
    EXPECT_EQ(first->write(4.0), WriteSuccess);
    EXPECT_EQ(last->last, 4.0);
    first->disconnect(true);  // neighbours hold each other
}

TEST(UserCode, DerivesPortsOfOtherProcesses) {
    RemoteInput in("in");
    base::PortInterface& port = in;
    EXPECT_FALSE(port.isLocal());
    EXPECT_EQ(port.serverProtocol(), 77);
    EXPECT_EQ(port.getTypeInfo()->getTypeName(), "double");
    boost::scoped_ptr<base::PortInterface> other(port.antiClone());
    EXPECT_TRUE(dynamic_cast<base::OutputPortInterface*>(other.get()));
    EXPECT_TRUE(dynamic_cast<base::InputPortInterface*>(&port));
    EXPECT_FALSE(dynamic_cast<base::OutputPortInterface*>(&port));

    RemoteOutput out("out");
    TaskContext component("component");
    component.ports()->addPort(in);
    component.ports()->addPort(out);
    EXPECT_EQ(component.getPort("in"), &in);
    EXPECT_EQ(component.getPort("out")->serverProtocol(), 77);
    InputPort<double> local("local");
    EXPECT_TRUE(out.createConnection(local, ConnPolicy()));
}

TEST(UserCode, DerivesAPolicyAndAnInterface) {
    LatchedPolicy policy;
    OutputPort<double> out("out");
    InputPort<double> in("in");
    out.write(1.5);
    ASSERT_TRUE(out.connectTo(&in, policy));
    double value = 0.0;
    EXPECT_EQ(in.read(value), NewData);
    EXPECT_EQ(value, 1.5);

    CountedPorts ports;
    ports.add(out).doc("what comes out");
    EXPECT_EQ(ports.getPorts().size(), 1u);
    EXPECT_EQ(ports.added, 1);
    EXPECT_EQ(ports.getPortDescription("out"), "what comes out");
}
