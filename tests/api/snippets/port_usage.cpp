// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports, as components use them.
#include <rtt/TaskContext.hpp>
#include <rtt/Port.hpp>
#include <rtt/base/DataObjectLockFree.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/os/Semaphore.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

/** Never registered anywhere. */
struct RobotData {
    uint64_t time;
    float padding[32];
};

class Sensor : public RTT::TaskContext {
public:
    RTT::InputPort<RobotData> raw;
    RTT::InputPort<double> command;
    InputPort<bool> estop_in;
    std::vector<InputPort<double>*> ports_;
    std::vector<boost::shared_ptr<OutputPort<double>>> outputs_;
    double seen;
    os::Semaphore done;

    Sensor() : TaskContext("sensor"), raw("raw"), command("command"), seen(0.0), done(0) {
        this->ports()->addEventPort("raw", raw).doc("wakes the component");
        this->addEventPort(command, boost::bind(&Sensor::commandCallback, this, _1)).doc("calls back");
        this->addEventPort("estop", estop_in, [this](base::PortInterface*) { done.signal(); });
        for (int i = 0; i < 2; ++i) {
            InputPort<double>* p = new InputPort<double>("in" + std::string(1, char('0' + i)));
            ports_.push_back(p);
            this->ports()->addPort(*p);
            outputs_.push_back(boost::shared_ptr<OutputPort<double>>(new OutputPort<double>("out")));
        }
    }
    ~Sensor() {
        stop();
        getActivity()->stop();
        for (std::vector<InputPort<double>*>::iterator it = ports_.begin(); it != ports_.end(); ++it) delete *it;
    }
    void updateHook() {
        RobotData data;
        if (raw.read(data) == NewData) {
            seen = data.padding[31];
            done.signal();
        }
    }
    void commandCallback(RTT::base::PortInterface* port) {
        if (port == &command && command.readNewest(seen) == NewData) done.signal();
    }
};

}  // namespace

TEST(UserCode, IsWokenByItsPorts) {
    Sensor sensor;
    OutputPort<RobotData> raw("raw");
    OutputPort<double> command("command");
    OutputPort<bool> estop("estop");
    ASSERT_TRUE(raw.connectTo(&sensor.raw));
    ASSERT_TRUE(command.connectTo(sensor.getPort("command")));
    ASSERT_TRUE(estop.connectTo(sensor.ports()->getPort("estop")));
    ASSERT_TRUE(sensor.start());
    RobotData data = RobotData();
    data.padding[31] = 1.5f;
    EXPECT_EQ(raw.write(data), WriteSuccess);
    sensor.done.wait();
    EXPECT_EQ(sensor.seen, 1.5);
    command.write(2.5);
    sensor.done.wait();
    EXPECT_EQ(sensor.seen, 2.5);
    estop.write(true);
    sensor.done.wait();
    EXPECT_EQ(sensor.ports_[0]->getInterface()->getOwner(), &sensor);
}

TEST(UserCode, ReadsAndWrites) {
    OutputPort<double> out("out", true);
    InputPort<double> in("in", ConnPolicy::buffer(3));
    double value = 9.0;
    EXPECT_EQ(in.read(value), NoData);
    EXPECT_EQ(value, 9.0);
    EXPECT_EQ(out.write(1.0), NotConnected);
    EXPECT_EQ(out.getLastWrittenValue(), 1.0);
    EXPECT_TRUE(out.keepsLastWrittenValue());
    out.keepNextWrittenValue(true);
    EXPECT_TRUE(out.keepsNextWrittenValue());
    out.keepNextWrittenValue(false);
    ASSERT_TRUE(in.connectTo(&out));
    for (int i = 1; i <= 3; ++i) out.write(i);
    WriteStatus full = out.write(4.0);
    EXPECT_NE(full, NotConnected) << "the buffer is full";
    FlowStatus fs = in.read(value);
    EXPECT_TRUE(fs == NewData && value == 1.0);
    EXPECT_EQ(in.readNewest(value, false), NewData);
    EXPECT_EQ(value, 3.0);
    value = 0.0;
    EXPECT_EQ(in.read(value, false), OldData);
    EXPECT_EQ(value, 0.0);
    while (in.read(value) == NewData) ADD_FAILURE();
    in.clear();
    EXPECT_EQ(in.read(value), NoData);
    EXPECT_STREQ(in.getTypeInfo()->getTypeName().c_str(), "double");
    in.disconnect();
    EXPECT_FALSE(in.connected());
}

TEST(UserCode, ChoosesAPolicy) {
    ConnPolicy policy = ConnPolicy::data(ConnPolicy::LOCK_FREE, true, false);
    policy.type = ConnPolicy::BUFFER;
    policy.size = 5;
    policy.init = true;
    policy.lock_policy = ConnPolicy::LOCKED;
    policy.pull = ConnPolicy::PUSH;
    policy.transport = 0;
    policy.data_size = 0;
    policy.name_id = "local";
    OutputPort<std::vector<double>> out("out");
    InputPort<std::vector<double>> in("in");
    std::vector<double> sample(7, 1.0);
    out.setDataSample(sample);
    out.write(sample);
    ASSERT_TRUE(out.createConnection(in, policy));
    std::vector<double> size;
    in.getDataSample(size);
    EXPECT_EQ(size.size(), 7u);
    EXPECT_EQ(in.read(size), NewData) << "init gives the last value";
    policy = ConnPolicy::circularBuffer(2, ConnPolicy::UNSYNC);
    EXPECT_EQ(policy.type, ConnPolicy::CIRCULAR_BUFFER);
    EXPECT_TRUE(out.disconnect(&in));
    EXPECT_FALSE(out.connectedTo(&in));
    EXPECT_EQ(ConnPolicy().type, ConnPolicy::DATA);
    ConnPolicy stream;
    stream.transport = 4711;
    stream.name_id = "/nowhere";
    EXPECT_FALSE(out.createStream(stream)) << "no transport has that number";
}

TEST(UserCode, MakesPortsFromPorts) {
    InputPort<int> in("in");
    boost::shared_ptr<base::PortInterface> opposite(in.antiClone());
    base::OutputPortInterface* out = dynamic_cast<base::OutputPortInterface*>(opposite.get());
    ASSERT_TRUE(out);
    EXPECT_TRUE(out->connectTo(&in));
    EXPECT_TRUE(out->write(new internal::ConstantDataSource<int>(5)) == WriteSuccess);
    base::DataSourceBase::shared_ptr source = in.getDataSource();
    EXPECT_TRUE(source->evaluate());
    EXPECT_EQ(internal::DataSource<int>::narrow(source.get())->value(), 5);
    boost::shared_ptr<base::PortInterface> same(in.clone());
    EXPECT_TRUE(same->setName("copy"));
    EXPECT_EQ(same->getName(), "copy");
    EXPECT_EQ(in.getManager()->getChannels().size(), 1u);
}

TEST(UserCode, KeepsADataObject) {
    base::DataObjectLockFree<std::vector<double>> object(std::vector<double>(3));
    std::vector<double> value;
    object.Set(std::vector<double>(3, 1.0));
    EXPECT_EQ(object.Get(value), NewData);
    EXPECT_EQ(value[2], 1.0);
    EXPECT_EQ(object.Get().size(), 3u);
}
