// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations by which scripts and others reach the samples of a port.
#include <gtest/gtest.h>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/RTT.hpp>
#include <rtt/internal/OperationCallerC.hpp>

#include <memory>

using namespace RTT;

namespace {

struct Sample {
    int number = 0;
    std::string text;
};

struct Component : TaskContext {
    Component() : TaskContext("component") {
        addPort(*in).doc("in");
        addPort(*out).doc("out");
        out->connectTo(in.get());
    }
    internal::OperationCallerC call(const std::string& port, const std::string& operation) {
        return internal::OperationCallerC(provides(port)->getPart(operation), operation, engine());
    }
    std::unique_ptr<InputPort<Sample>> in{new InputPort<Sample>("in")};
    std::unique_ptr<OutputPort<Sample>> out{new OutputPort<Sample>("out")};
};

Sample sampleOf(int number) { return {number, std::to_string(number)}; }

}  // namespace

TEST(PortOperations, AreCalledWithoutKnowingTheType) {
    Component c;
    Sample got, last;
    FlowStatus flow = NoData;
    WriteStatus written = WriteFailure;
    internal::OperationCallerC read = c.call("in", "read"), write = c.call("out", "write"), old = c.call("out", "last");
    read.arg(got).ret(flow);
    write.argC(sampleOf(5)).ret(written);
    old.ret(last);

    last = sampleOf(1);
    EXPECT_TRUE(old.call());
    EXPECT_EQ(last.number, 0) << "a default value while there is none";
    EXPECT_TRUE(write.call() && read.call() && old.call());
    EXPECT_EQ(written, WriteSuccess);
    EXPECT_EQ(flow, NewData);
    EXPECT_EQ(got.text, "5");
    EXPECT_EQ(last.text, "5");
    EXPECT_TRUE(read.call());
    EXPECT_EQ(flow, OldData);
}

TEST(PortOperations, TellTheirArgumentsAndResults) {
    Component c;
    OperationInterfacePart* const read = c.provides("in")->getPart("read");
    OperationInterfacePart* const write = c.provides("out")->getPart("write");
    OperationInterfacePart* const last = c.provides("out")->getPart("last");
    EXPECT_EQ(read->description(), "Reads a sample from the port.");
    ASSERT_EQ(read->arity(), 1u);
    EXPECT_EQ(read->getArgumentList().front().name, "sample");
    EXPECT_EQ(read->getArgumentType(1), c.in->getTypeInfo());
    EXPECT_EQ(write->getArgumentType(1), c.in->getTypeInfo());
    EXPECT_EQ(write->resultType(), internal::DataSourceTypeInfo<WriteStatus>::getType());
    EXPECT_EQ(last->arity(), 0u);
    EXPECT_EQ(last->getArgumentType(0), c.in->getTypeInfo());
}

TEST(PortOperations, AreNotSent) {
    Component c;
    OperationInterfacePart* const read = c.provides("in")->getPart("read");
    Sample got;
    EXPECT_TRUE(read->isSynchronous());
    EXPECT_THROW(read->produceSend({new internal::ReferenceDataSource<Sample>(got)}, c.engine()),
                 no_asynchronous_operation_exception);
    OperationCaller<FlowStatus(Sample&)> typed = read;
    ASSERT_TRUE(typed.ready());
    EXPECT_EQ(typed.send(got).collect(), SendFailure);
}

TEST(PortOperations, FindThePortGoneThatTheirCallersOutlive) {
    Component c;
    OperationCaller<FlowStatus(Sample&)> read = c.provides("in")->getOperation("read");
    OperationCaller<WriteStatus(const Sample&)> write = c.provides("out")->getOperation("write");
    OperationCaller<Sample()> last = c.provides("out")->getOperation("last");
    EXPECT_EQ(write(sampleOf(3)), WriteSuccess);
    EXPECT_EQ(last().number, 3);
    c.in.reset();
    c.out.reset();
    Sample got = sampleOf(7);
    EXPECT_EQ(read(got), NoData);
    EXPECT_EQ(got.number, 7);
    EXPECT_EQ(write(got), NotConnected);
    EXPECT_EQ(last().number, 0);
}

TEST(PortOperations, CanBeReplaced) {
    Component c;
    Operation<Sample()> other("other", [] { return sampleOf(42); });
    Operation<int()> wrong("wrong", [] { return 1; });
    EXPECT_FALSE(c.provides("out")->resetOperation("last", &wrong));
    ASSERT_TRUE(c.provides("out")->resetOperation("last", &other));
    OperationCaller<Sample()> last = c.provides("out")->getOperation("last");
    EXPECT_EQ(last().number, 42);
    Sample got;
    internal::OperationCallerC generic = c.call("out", "last");
    EXPECT_TRUE(generic.ret(got).call());
    EXPECT_EQ(got.number, 42);
}

TEST(PortOperations, LeaveADataSourceItsLastValue) {
    Component c;
    const base::DataSourceBase::shared_ptr in = c.in->getDataSource(), out = c.out->getDataSource();
    EXPECT_FALSE(out->evaluate());
    c.out->write(sampleOf(9));
    EXPECT_TRUE(in->evaluate() && out->evaluate());
    c.in.reset();
    c.out.reset();
    EXPECT_FALSE(in->evaluate() || out->evaluate());
    EXPECT_EQ(internal::DataSource<Sample>::narrow(in.get())->value().number, 9);
    EXPECT_EQ(internal::DataSource<Sample>::narrow(out.get())->get().number, 9);
}
