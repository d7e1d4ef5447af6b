// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calling operations through data sources, as consoles and scripts do.
#include "probe.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::Probe;

namespace {

struct GenericCall : testing::Test {
    Probe c{"server"};
    ExecutionEngine* global = GlobalEngine::Instance();
    typedef base::DataSourceBase::shared_ptr Source;

    GenericCall() {
        c.addOperation(
            "add", [](int a, int b) { return a + b; }, OwnThread);
        c.addOperation(
            "divide", [](int a, int b, int& rest) { return rest = a % b, a / b; }, OwnThread);
        c.addOperation("hello", [](const std::string& name) { return "hello " + name; });
        c.addOperation("nothing", [this] { ++calls; });
        c.addOperation(
            "bad", []() -> int { throw std::runtime_error("planted"); }, OwnThread);
        c.provides()->addSynchronousOperation("only_call", [] { return 1; });
    }
    OperationInterfacePart* part(const char* name) { return c.getOperation(name); }
    static Source constant(int n) { return new ConstantDataSource<int>(n); }
    int calls = 0;
};

TEST_F(GenericCall, ProducedSourceCallsWithEachEvaluation) {
    ValueDataSource<int>::shared_ptr a(new ValueDataSource<int>(1));
    Source source = part("add")->produce({a, constant(10)}, global);
    auto* sum = DataSource<int>::narrow(source.get());
    ASSERT_TRUE(sum);
    EXPECT_EQ(sum->get(), 11);
    a->set(5);
    EXPECT_EQ(sum->value(), 11) << "not evaluated again";
    EXPECT_EQ(sum->get(), 15);
}

TEST_F(GenericCall, SourceWithoutResultIsEvaluatedToo) {
    Source source = part("nothing")->produce({}, nullptr);
    EXPECT_TRUE(source->evaluate());
    EXPECT_TRUE(source->evaluate());
    EXPECT_EQ(calls, 2);
}

TEST_F(GenericCall, ArgumentsByReferenceAreWrittenBack) {
    ValueDataSource<int>::shared_ptr rest(new ValueDataSource<int>(0));
    Source source = part("divide")->produce({constant(17), constant(5), rest}, global);
    ASSERT_TRUE(source->evaluate());
    EXPECT_EQ(rest->get(), 2);
}

TEST_F(GenericCall, WrongArgumentsAreToldApart) {
    EXPECT_THROW(part("add")->produce({constant(1)}, global), wrong_number_of_args_exception);
    EXPECT_THROW(part("add")->produce({constant(1), new ConstantDataSource<std::string>("x")}, global),
                 wrong_types_of_args_exception);
    EXPECT_THROW(part("add")->produce({constant(1), nullptr}, global), wrong_types_of_args_exception);
    EXPECT_THROW(part("divide")->produce({constant(1), constant(1), constant(1)}, global), non_lvalue_args_exception);
    EXPECT_THROW(part("only_call")->produceSend({}, global), no_asynchronous_operation_exception);
    EXPECT_THROW(c.operations()->produce("missing", {}, global), name_not_found_exception);
    try {
        part("add")->produce({constant(1), new ConstantDataSource<std::string>("x")}, global);
    } catch (const wrong_types_of_args_exception& error) {
        EXPECT_EQ(error.whicharg, 2);
    }
}

TEST_F(GenericCall, SendHandleAndCollect) {
    Source handle = part("divide")->produceHandle();
    ValueDataSource<int>::shared_ptr result(new ValueDataSource<int>(0)), rest(new ValueDataSource<int>(0));
    Source sending = part("divide")->produceSend({constant(17), constant(5), rest}, global);
    ASSERT_TRUE(handle->update(sending.get()));
    Source collecting = part("divide")->produceCollect({handle, result, rest}, new ConstantDataSource<bool>(true));
    EXPECT_EQ(DataSource<SendStatus>::narrow(collecting.get())->get(), SendSuccess);
    EXPECT_EQ(result->get(), 3);
    EXPECT_EQ(rest->get(), 2);
}

TEST_F(GenericCall, CallerC) {
    int a = 2, sum = 0;
    OperationCallerC add(part("add"), "add", global);
    EXPECT_FALSE(add.ready());
    EXPECT_FALSE(add.call());
    add.argC(3);
    EXPECT_THROW(add.check(), wrong_number_of_args_exception);
    add.arg(a).ret(sum);
    EXPECT_TRUE(add.ready());
    EXPECT_TRUE(add.call());
    EXPECT_EQ(sum, 5);
    a = 10;
    EXPECT_TRUE(add.call());
    EXPECT_EQ(sum, 13);

    std::string greeting;
    EXPECT_TRUE(OperationCallerC(part("hello"), "hello", nullptr).argC(std::string("you")).ret(greeting).call());
    EXPECT_EQ(greeting, "hello you");
    EXPECT_FALSE(OperationCallerC(part("hello"), "hello", nullptr).argC(std::string("you")).ret(sum).call())
        << "no way from string to int";
    EXPECT_FALSE(OperationCallerC(nullptr, "missing", nullptr).call());
    EXPECT_THROW(OperationCallerC(part("bad"), "bad", global).call(), std::runtime_error);
}

TEST_F(GenericCall, CallerCSendsAndHandleCollects) {
    int rest = 0, result = 0;
    SendHandleC handle = OperationCallerC(part("divide"), "divide", global).argC(17).argC(5).arg(rest).send();
    EXPECT_EQ(handle.collect(), SendSuccess);
    handle.arg(result);
    EXPECT_FALSE(handle.ready()) << "one of two values";
    handle.arg(rest);
    EXPECT_EQ(handle.collectIfDone(), SendSuccess);
    EXPECT_EQ(result, 3);
    EXPECT_EQ(rest, 2);
    EXPECT_EQ(SendHandleC().collect(), SendFailure);
    EXPECT_FALSE(OperationCallerC(part("only_call"), "only_call", global).send().ready());
}

TEST_F(GenericCall, DescriptionOutlivesTheOperationObject) {
    {
        Operation<int(int)> member("member", [](int n) { return n; });
        c.addOperation(member).doc("text");
    }
    EXPECT_EQ(part("member")->description(), "text");
    EXPECT_EQ(part("member")->getName(), "member");
}

}  // namespace
