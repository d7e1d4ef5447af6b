// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Generic calls with what scripts give them: expressions and variables of the built-in types.
#include "../types/builtin_typekit.hpp"
#include "probe.hpp"

#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <rtt/types/Operators.hpp>

#include <cstdint>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::eventually;
using oroforge::test::Probe;
using types_test::SourcePtr;
using types_test::variable;

namespace {

struct Unregistered {
    int number = 0;
};

struct TypedArguments : types_test::WithBuiltinTypes {
    Probe c{"server"};
    std::vector<int> called;

    TypedArguments() {
        c.addOperation("speed", [this](int n) { called.push_back(n); });
        c.addOperation("small", [this](std::int8_t n) { called.push_back(n); });
        c.addOperation("real", [this](double x) { called.push_back(static_cast<int>(x * 10)); });
        c.addEventOperation("event", [](int, const std::string&) {});
        c.addEventOperation("odd", [](const Unregistered&) {});
    }
    OperationInterfacePart* part(const char* name) { return c.getOperation(name); }
    static SourcePtr divided(SourcePtr a, SourcePtr b) {
        return types::operators()->applyBinary("/", a.get(), b.get());
    }
};

TEST_F(TypedArguments, DivisionByZeroCallsNothing) {
    auto divisor = variable(4);
    SourcePtr source = part("speed")->produce({divided(variable(100), divisor)}, nullptr);
    ASSERT_TRUE(source->evaluate());
    divisor->set(0);
    EXPECT_FALSE(source->evaluate());
    EXPECT_EQ(called, std::vector<int>{25}) << "the value before was used again";
}

TEST_F(TypedArguments, ConversionThatDoesNotFitCallsNothing) {
    auto number = variable(1000);
    OperationCallerC small(part("small"), "small", nullptr);
    small.arg(SourcePtr(number));
    EXPECT_FALSE(small.call());
    EXPECT_TRUE(called.empty());
    number->set(100);
    EXPECT_TRUE(small.call());
    EXPECT_EQ(called, std::vector<int>{100});
}

TEST_F(TypedArguments, AreConvertedWithEachCall) {
    auto number = variable(2);
    SourcePtr source = part("real")->produce({number}, nullptr);
    EXPECT_TRUE(source->evaluate());
    number->set(3);
    EXPECT_TRUE(source->evaluate());
    EXPECT_EQ(called, (std::vector<int>{20, 30}));
}

TEST_F(TypedArguments, UnknownTypesAreNamedSo) {
    EXPECT_EQ(part("odd")->getArgumentList().at(0).type.substr(0, 9), "unknown_t");
    EXPECT_EQ(part("event")->getArgumentList().at(0).type, "int");
    EXPECT_EQ(part("event")->resultType(), "void");
}

/** Writes down the values of two variables. */
struct Recorder : base::ActionInterface {
    std::function<void()> record;
    void readArguments() override {}
    bool execute() override { return record(), true; }
    base::ActionInterface* clone() const override { return nullptr; }
};

TEST_F(TypedArguments, EventsBringThemToTheSubscribersThread) {
    Probe subscriber{"subscriber"};
    auto number = variable(0);
    auto text = variable("");
    std::vector<std::string> heard;  // touched by the subscriber's thread
    std::atomic<std::size_t> count{0};
    auto* recorder = new Recorder;
    recorder->record = [&] {
        heard.push_back(text->get() + std::to_string(number->get()));
        count = heard.size();
    };
    Handle handle = part("event")->produceSignal(recorder, {number, text}, subscriber.engine());
    OperationCaller<void(int, const std::string&)> event = c.getOperation("event");
    for (int i = 0; i != 20; ++i) event(i, "number ");
    ASSERT_TRUE(eventually([&] { return count == 20; }));
    for (int i = 0; i != 20; ++i) EXPECT_EQ(heard[static_cast<std::size_t>(i)], "number " + std::to_string(i));
}

TEST_F(TypedArguments, EventsOfUnknownTypesStayInTheirThread) {
    typedef ValueDataSource<Unregistered> Variable;
    Variable::shared_ptr odd(new Variable());
    EXPECT_THROW(part("odd")->produceSignal(nullptr, {odd}, c.engine()), std::exception) << "it cannot be copied";
    Handle handle = part("odd")->produceSignal(nullptr, {odd}, nullptr);
    OperationCaller<void(const Unregistered&)>(c.getOperation("odd"))(Unregistered{4});
    EXPECT_EQ(odd->rvalue().number, 4);
}

}  // namespace
