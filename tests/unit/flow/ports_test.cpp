// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What one port does, and two by the simplest connection.
#include "log_capture.hpp"

#include <rtt/Port.hpp>
#include <rtt/internal/DataSources.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <vector>

using namespace RTT;

TEST(OutputPort, SaysNotConnectedButRemembersTheValue) {
    OutputPort<double> out("out");
    EXPECT_EQ(out.write(2.5), NotConnected);
    double last = 0;
    EXPECT_TRUE(out.getLastWrittenValue(last));
    EXPECT_EQ(last, 2.5);
}

TEST(OutputPort, HasNoLastValueBeforeTheFirstWrite) {
    OutputPort<double> out("out");
    double last = 7;
    EXPECT_FALSE(out.getLastWrittenValue(last));
    EXPECT_EQ(last, 7);
    EXPECT_EQ(out.getLastWrittenValue(), 0.0);
}

TEST(OutputPort, RemembersNothingIfToldSo) {
    OutputPort<double> out("out", false);
    EXPECT_FALSE(out.keepsLastWrittenValue());
    out.write(1);
    double last = 7;
    EXPECT_FALSE(out.getLastWrittenValue(last));
    out.keepLastWrittenValue(true);
    out.write(2);
    EXPECT_TRUE(out.getLastWrittenValue(last));
    EXPECT_EQ(last, 2);
    out.keepLastWrittenValue(false);
    out.write(3);
    EXPECT_FALSE(out.getLastWrittenValue(last));
}

TEST(OutputPort, RemembersOnlyTheNextValueIfToldSo) {
    OutputPort<double> out("out", false);
    out.keepNextWrittenValue(true);
    out.write(1);
    EXPECT_EQ(out.getLastWrittenValue(), 1);
    out.write(2);
    double last = 7;
    EXPECT_FALSE(out.getLastWrittenValue(last));
}

TEST(OutputPort, ForgetsTheLastValueOnClearAndOnSetDataSample) {
    OutputPort<double> out("out");
    double last = 7;
    out.write(1);
    out.clear();
    EXPECT_FALSE(out.getLastWrittenValue(last));
    out.write(1);
    out.setDataSample(5);
    EXPECT_FALSE(out.getLastWrittenValue(last));
    EXPECT_EQ(last, 7);
}

TEST(InputPort, GivesNoDataAndLeavesTheArgumentWhenNotConnected) {
    InputPort<double> in("in");
    double got = 7;
    EXPECT_EQ(in.read(got), NoData);
    EXPECT_EQ(in.readNewest(got), NoData);
    EXPECT_EQ(got, 7);
    in.clear();
    EXPECT_FALSE(in.connected());
}

TEST(Ports, BringASampleAcross) {
    OutputPort<double> out("out");
    InputPort<double> in("in");
    ASSERT_TRUE(out.connectTo(&in));
    EXPECT_TRUE(out.connected() && in.connected());
    double got = 0;
    EXPECT_EQ(out.write(2.5), WriteSuccess);
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, 2.5);
    got = 7;
    EXPECT_EQ(in.read(got, false), OldData);
    EXPECT_EQ(got, 7);
    EXPECT_EQ(in.read(got), OldData);
    EXPECT_EQ(got, 2.5);
    in.clear();
    EXPECT_EQ(in.read(got), NoData);
}

TEST(Ports, CarryTypesThatNoTypekitKnows) {
    typedef struct {
        unsigned long time;
        float padding[32];
    } Raw;
    OutputPort<Raw> out("out");
    InputPort<Raw> in("in");
    ASSERT_TRUE(out.connectTo(&in));
    Raw sent = {}, got = {};
    sent.time = 42;
    sent.padding[31] = 1.5f;
    out.write(sent);
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got.time, 42u);
    EXPECT_EQ(got.padding[31], 1.5f);
}

TEST(Ports, ReadNewestSkipsOlderSamples) {
    OutputPort<int> out("out");
    InputPort<int> in("in");
    out.connectTo(&in, ConnPolicy::buffer(10));
    for (int i = 1; i <= 5; ++i) out.write(i);
    int got = 0;
    EXPECT_EQ(in.readNewest(got), NewData);
    EXPECT_EQ(got, 5);
    EXPECT_EQ(in.readNewest(got), OldData);
}

TEST(Ports, SizeSamplesWithoutDeliveringThem) {
    typedef std::vector<double> Samples;
    OutputPort<Samples> out("out");
    InputPort<Samples> early("early"), late("late");
    out.connectTo(&early);
    out.setDataSample(Samples(100, 1.0));
    out.connectTo(&late, ConnPolicy::data());
    for (InputPort<Samples>* in : {&early, &late}) {
        Samples got(1, 9.0);
        EXPECT_EQ(in->read(got), NoData);
        EXPECT_EQ(got, Samples(1, 9.0));
        in->getDataSample(got);
        EXPECT_EQ(got.size(), 100u);
    }
}

TEST(Ports, AreNamedAndDescribed) {
    InputPort<int> in;
    EXPECT_EQ(in.getName(), "unnamed");
    EXPECT_TRUE(in.setName("in"));
    EXPECT_EQ(in.getFullName(), "in");
    EXPECT_EQ(&in.doc("what it is for"), &in);
    EXPECT_EQ(in.getDescription(), "what it is for");
    OutputPort<int> out("out");
    out.connectTo(&in);
    EXPECT_FALSE(in.setName("other"));
    EXPECT_EQ(in.getName(), "in");
    EXPECT_TRUE(in.isLocal());
    EXPECT_EQ(in.serverProtocol(), 0);
}

TEST(Ports, AreClonedInBothDirections) {
    InputPort<int> in("in", ConnPolicy::buffer(4));
    OutputPort<int> out("out", false);
    std::unique_ptr<InputPort<int>> in2(in.clone());
    std::unique_ptr<base::PortInterface> out2(in.antiClone());
    std::unique_ptr<OutputPort<int>> out3(out.clone());
    std::unique_ptr<base::PortInterface> in3(out.antiClone());
    EXPECT_EQ(in2->getDefaultPolicy().size, 4);
    EXPECT_FALSE(out3->keepsLastWrittenValue());
    EXPECT_TRUE(out2->connectTo(in2.get()));
    EXPECT_TRUE(in3->connectTo(out3.get()));
    EXPECT_EQ(out2->getName(), "in");
}

TEST(Ports, ReadAndWriteDataSources) {
    OutputPort<double> out("out");
    InputPort<double> in("in");
    out.connectTo(&in);
    internal::ValueDataSource<double>::shared_ptr value = new internal::ValueDataSource<double>(1.5);
    EXPECT_EQ(out.write(base::DataSourceBase::shared_ptr(value)), WriteSuccess);
    value->set(0);
    EXPECT_EQ(in.read(base::DataSourceBase::shared_ptr(value)), NewData);
    EXPECT_EQ(value->get(), 1.5);
}

TEST(Ports, RefuseDataSourcesOfAnotherType) {
    flow_test::LogCapture log;
    OutputPort<double> out("out");
    InputPort<double> in("in");
    out.connectTo(&in);
    out.write(2.0);
    base::DataSourceBase::shared_ptr other = new internal::ValueDataSource<int>(1);
    EXPECT_EQ(in.read(other), NoData);
    EXPECT_EQ(out.write(other), WriteFailure);
    EXPECT_EQ(in.read(base::DataSourceBase::shared_ptr()), NoData);
    EXPECT_TRUE(log.contains("trying to read to an incompatible data source")) << log.text();
    double got = 0;
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, 2.0);
}

TEST(Ports, GiveDataSourcesOfThemselves) {
    OutputPort<double> out("out");
    internal::DataSource<double>::shared_ptr last, read;
    {
        InputPort<double> in("in");
        out.connectTo(&in);
        last = dynamic_cast<internal::DataSource<double>*>(out.getDataSource());
        read = dynamic_cast<internal::DataSource<double>*>(in.getDataSource());
        ASSERT_TRUE(last && read);
        EXPECT_FALSE(read->evaluate());
        out.write(3.5);
        EXPECT_EQ(last->get(), 3.5);
        EXPECT_EQ(read->get(), 3.5);
    }
    EXPECT_FALSE(read->evaluate());  // the port is gone
    EXPECT_EQ(read->value(), 3.5);
}
