// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations of a service by their names, for users that learn of them at run time.
#include "../types/builtin_typekit.hpp"
#include "probe.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/Handle.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <gmock/gmock.h>

using namespace RTT;
using oroforge::test::Probe;
using testing::ElementsAre;
using types_test::SourcePtr;
using types_test::variable;

namespace {

struct ByName : types_test::WithBuiltinTypes {
    ByName() {
        Service& service = *c.provides("arithmetic");
        service
            .addOperation(
                "divide", [](int a, int b, int& rest) { return rest = a % b, a / b; }, OwnThread)
            .doc("Divides.")
            .arg("a", "what")
            .arg("b", "by what");
        service.addSynchronousOperation("abs", [](int n) { return n < 0 ? -n : n; });
        service.addEventOperation("beep", [] {});
    }
    Probe c{"c"};
    const OperationInterface& operations = *c.provides("arithmetic")->operations();
    ExecutionEngine* global = internal::GlobalEngine::Instance();
};

TEST_F(ByName, NamesAreListedAndFound) {
    EXPECT_THAT(operations.getNames(), ElementsAre("abs", "beep", "divide"));
    EXPECT_EQ(operations.getOperationNames(), operations.getNames());
    EXPECT_TRUE(operations.hasMember("abs") && operations.hasOperation("abs"));
    EXPECT_FALSE(operations.hasMember("none") || operations.hasOperation("none"));
    ASSERT_TRUE(operations.getPart("divide"));
    EXPECT_EQ(operations.getPart("divide")->getName(), "divide");
    EXPECT_EQ(operations.getPart("none"), nullptr);
}

TEST_F(ByName, SignatureIsDescribed) {
    EXPECT_EQ(operations.getResultType("divide"), "int");
    EXPECT_EQ(operations.getDescription("divide"), "Divides.");
    EXPECT_EQ(operations.getArity("divide"), 3);
    const auto arguments = operations.getArgumentList("divide");
    ASSERT_EQ(arguments.size(), 3u);
    EXPECT_EQ(arguments[0].name + arguments[0].description + arguments[0].type, "awhatint");
    EXPECT_EQ(arguments[2].name + arguments[2].description, "arg3") << "not documented";
    EXPECT_EQ(operations.getCollectArity("divide"), 2) << "result and reference";
    ASSERT_TRUE(operations.getCollectType("divide", 1));
    EXPECT_EQ(operations.getCollectType("divide", 1)->getTypeName(), "int");
    EXPECT_EQ(operations.getCollectType("divide", 3), nullptr);
    EXPECT_TRUE(operations.isSynchronous("abs"));
    EXPECT_FALSE(operations.isSynchronous("divide"));
}

TEST_F(ByName, CallSendAndSignalAreProduced) {
    const auto rest = variable(0), quotient = variable(0);
    const OperationInterface::Args args{variable(17), variable(5), rest};
    EXPECT_EQ(types_test::valueOf<int>(operations.produce("divide", args, global)), 3);
    EXPECT_EQ(rest->get(), 2);

    const SourcePtr handle = operations.produceHandle("divide");
    ASSERT_TRUE(handle->update(operations.produceSend("divide", args, global).get()));
    const SourcePtr collecting =
        operations.produceCollect("divide", {handle, quotient, rest}, new internal::ConstantDataSource<bool>(true));
    EXPECT_EQ(types_test::valueOf<SendStatus>(collecting), SendSuccess);
    EXPECT_EQ(quotient->get(), 3);

    Handle listening = operations.produceSignal("beep", nullptr, {}, nullptr);
    EXPECT_TRUE(listening.connected());
    EXPECT_THROW(operations.produceSend("abs", {variable(1)}, global), no_asynchronous_operation_exception);
}

TEST_F(ByName, UnknownNamesAreRefused) {
    EXPECT_THROW(operations.produce("none", {}, global), name_not_found_exception);
    EXPECT_THROW(operations.produceSend("none", {}, global), name_not_found_exception);
    EXPECT_THROW(operations.produceHandle("none"), name_not_found_exception);
    EXPECT_THROW(operations.produceCollect("none", {}, nullptr), name_not_found_exception);
    EXPECT_THROW(operations.produceSignal("none", nullptr, {}, nullptr), name_not_found_exception);
    EXPECT_THROW(operations.getArgumentList("none"), name_not_found_exception);
    EXPECT_THROW(operations.getResultType("none"), name_not_found_exception);
    EXPECT_THROW(operations.getArity("none"), name_not_found_exception);
    EXPECT_THROW(operations.getCollectArity("none"), name_not_found_exception);
    EXPECT_THROW(operations.getCollectType("none", 1), name_not_found_exception);
    EXPECT_THROW(operations.getDescription("none"), name_not_found_exception);
    EXPECT_THROW(operations.isSynchronous("none"), name_not_found_exception);
}

}  // namespace
