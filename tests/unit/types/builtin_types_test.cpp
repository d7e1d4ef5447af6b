// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The built-in typekit: types, conversions, constructors, operators, globals (spec 5.4 to 5.6).
#include "builtin_typekit.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/FlowStatus.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/os/tlsf/tlsf.h>
#include <rtt/rt_string.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/TemplateConstructor.hpp>

using namespace RTT;
using namespace types_test;

namespace {

class BuiltinTypes : public WithBuiltinTypes {};

template <class T>
SourcePtr constant(T value) {
    return new internal::ConstantDataSource<T>(value);
}

SourcePtr apply(const SourcePtr& a, const char* op, const SourcePtr& b) {
    return types::operators()->applyBinary(op, a.get(), b.get());
}

SourcePtr apply(const char* op, const SourcePtr& a) { return types::operators()->applyUnary(op, a.get()); }

SourcePtr construct(const char* name, std::vector<SourcePtr> arguments) { return type(name)->construct(arguments); }

}  // namespace

TEST_F(BuiltinTypes, AllAreThere) {
    for (const char* name :
         {"int",         "uint",       "llong",        "ullong",      "double",     "float",       "char",
          "bool",        "void",       "string",       "array",       "FlowStatus", "WriteStatus", "SendStatus",
          "PropertyBag", "ConnPolicy", "BufferPolicy", "TaskContext", "int8",       "uint8",       "int16",
          "uint16",      "int64",      "uint64",       "rt_string",   "SendHandle"})
        EXPECT_NE(nullptr, type(name)) << name;
}

TEST_F(BuiltinTypes, Texts) {
    EXPECT_EQ("true", variable(true)->toString());
    EXPECT_EQ("3.14159", variable(3.14159265)->toString());
    EXPECT_EQ("two words", variable("two words")->toString());
    EXPECT_EQ("{1, 2.5}", variable(std::vector<double>{1, 2.5})->toString());
    EXPECT_EQ("NewData", variable(NewData)->toString());
    EXPECT_EQ("-5", variable<signed char>(-5)->toString());
    EXPECT_NE(std::string::npos, variable(ConnPolicy::buffer(4))->toString().find("size = 4"));
}

TEST_F(BuiltinTypes, TextsAreRead) {
    auto text = variable("");
    EXPECT_TRUE(type("string")->fromString("two words", text));
    EXPECT_EQ("two words", text->get());
    auto yes = variable(false);
    EXPECT_TRUE(type("bool")->fromString("true", yes));
    EXPECT_TRUE(yes->get());
    EXPECT_FALSE(type("bool")->fromString("maybe", yes));
    auto number = variable(0);
    EXPECT_FALSE(type("int")->fromString("x", number));
}

TEST_F(BuiltinTypes, StringMembers) {
    auto text = variable("abc");
    EXPECT_EQ(3, valueOf<int>(text->getMember("size")));
    EXPECT_EQ('b', valueOf<char>(text->getMember("1")));
    ASSERT_TRUE(text->getMember("1")->update(variable('x').get()));
    EXPECT_EQ("axc", text->get());
    EXPECT_TRUE(type("string")->resize(text, 5));
    EXPECT_EQ(5u, text->rvalue().size());
}

TEST_F(BuiltinTypes, BagsDoNotChangeStrings) {
    const auto text = variable("abc");
    const auto realTime = variable(rt_string("abc"));
    for (const bool empty : {true, false}) {
        const auto bag = variable(PropertyBag());
        if (!empty) bag->set().ownProperty(new Property<std::string>("first", "", "x"));
        EXPECT_FALSE(type("string")->composeType(bag, text));
        EXPECT_FALSE(type("rt_string")->composeType(bag, realTime));
        PropertyBag target, source;
        auto* property = new Property<std::string>("p", "", "abc");
        target.ownProperty(property);
        source.ownProperty(new Property<PropertyBag>("p", "", bag->get()));
        EXPECT_FALSE(refreshProperties(target, source));
        EXPECT_EQ("abc", property->get());
    }
    EXPECT_EQ("abc", text->get());
    EXPECT_EQ("abc", realTime->get());
}

TEST_F(BuiltinTypes, SilentConversions) {
    EXPECT_EQ(3.0, valueOf<double>(type("double")->convert(variable(3))));
    EXPECT_EQ(2, valueOf<int>(type("int")->convert(variable(2u))));
    EXPECT_EQ(1, valueOf<int>(type("int")->convert(variable(true))));
    EXPECT_TRUE(valueOf<bool>(type("bool")->convert(variable(NewData))));
    EXPECT_FALSE(valueOf<bool>(type("bool")->convert(variable(NoData))));
    EXPECT_TRUE(valueOf<bool>(type("bool")->convert(variable(WriteSuccess))));
    EXPECT_FALSE(valueOf<bool>(type("bool")->convert(variable(SendNotReady))));
    EXPECT_EQ(2, valueOf<int>(type("int")->convert(variable(PerInputPort))));
    EXPECT_EQ(Shared, valueOf<BufferPolicy>(type("BufferPolicy")->convert(variable(4))));
}

TEST_F(BuiltinTypes, ConversionsThatDoNotExistLeaveTheSource) {
    const SourcePtr text = variable("5");
    EXPECT_EQ(text, type("int")->convert(text));
    const SourcePtr number = variable(5u);
    EXPECT_EQ(number, type("double")->convert(number)) << "conversions are not chained";
}

TEST_F(BuiltinTypes, ConversionsFollowTheirSource) {
    auto number = variable(1);
    const SourcePtr converted = type("double")->convert(number);
    number->set(2);
    EXPECT_EQ(2.0, valueOf<double>(converted));
}

TEST_F(BuiltinTypes, SmallNumbersRefuseWhatDoesNotFit) {
    auto small = variable<short>(1);
    EXPECT_TRUE(small->update(type("int16")->convert(variable(30000)).get()));
    EXPECT_EQ(30000, small->get());
    EXPECT_FALSE(small->update(type("int16")->convert(variable(70000)).get()));
    EXPECT_EQ(30000, small->get());
    auto tiny = variable<unsigned char>(1);
    EXPECT_FALSE(tiny->update(type("uint8")->convert(variable(-1)).get()));
}

TEST_F(BuiltinTypes, Constructors) {
    EXPECT_EQ(std::vector<double>(10, 0.0), valueOf<std::vector<double>>(construct("array", {constant(10)})));
    EXPECT_EQ(std::vector<double>{10.0}, valueOf<std::vector<double>>(construct("array", {constant(10.0)})));
    EXPECT_EQ((std::vector<double>{1, 2}),
              valueOf<std::vector<double>>(construct("array", {constant(1.0), constant(2.0)})));
    EXPECT_EQ(std::vector<double>(3, 0.5),
              valueOf<std::vector<double>>(construct("array", {constant(3), constant(0.5)})));
    EXPECT_EQ(std::vector<double>(), valueOf<std::vector<double>>(construct("array", {})));
    EXPECT_EQ(nullptr, construct("array", {constant(std::string("x"))}));
    EXPECT_EQ(3, valueOf<int>(construct("int", {constant(3.7)})));
}

TEST_F(BuiltinTypes, ConstructedStringsDoNotShareTheirStorage) {
    const SourcePtr first = construct("string", {constant(2)}), second = construct("string", {constant(4)});
    EXPECT_EQ(2u, valueOf<std::string>(first).size());
    EXPECT_EQ(4u, valueOf<std::string>(second).size());
    EXPECT_EQ(2u, valueOf<std::string>(first).size());
}

TEST_F(BuiltinTypes, ConstructFromTheSameTypeIsTheArgument) {
    const SourcePtr number = variable(5);
    EXPECT_EQ(number, construct("int", {number}));
}

TEST_F(BuiltinTypes, OperatorsOfNumbers) {
    EXPECT_EQ(3, valueOf<int>(apply(constant(1), "+", constant(2))));
    EXPECT_EQ(0.5, valueOf<double>(apply(constant(1.0), "/", constant(2.0))));
    EXPECT_EQ(1, valueOf<int>(apply(constant(7), "%", constant(3))));
    EXPECT_TRUE(valueOf<bool>(apply(constant(2u), "<", constant(3u))));
    EXPECT_EQ(-4, valueOf<int>(apply("-", constant(4))));
    EXPECT_EQ(-4, valueOf<int>(apply("-", constant(4u)))) << "of the first type that has it and can be made of it";
    EXPECT_FALSE(valueOf<bool>(apply("!", constant(5))));
    EXPECT_EQ(nullptr, apply("-", constant(std::string("4"))));
    EXPECT_EQ(nullptr, apply(constant(1.0), "%", constant(2.0)));
}

TEST_F(BuiltinTypes, SecondOperandIsConverted) {
    EXPECT_EQ(3, valueOf<int>(apply(constant(1), "+", constant(2.5))));
    EXPECT_EQ(3.0, valueOf<double>(apply(constant(1.0), "+", constant(2))));
}

TEST_F(BuiltinTypes, DivisionByZeroFailsInsteadOfCrashing) {
    for (const char* op : {"/", "%"}) {
        const SourcePtr result = apply(constant(5), op, constant(0));
        ASSERT_TRUE(result);
        EXPECT_FALSE(result->evaluate()) << op;
        EXPECT_EQ(0, valueOf<int>(result)) << op;
    }
    EXPECT_EQ(std::numeric_limits<int>::min(),
              valueOf<int>(apply(constant(std::numeric_limits<int>::min()), "/", constant(-1))));
}

TEST_F(BuiltinTypes, OperatorsOfTextAndLogic) {
    EXPECT_EQ("a1", valueOf<std::string>(apply(constant(std::string("a")), "+", constant(1))));
    EXPECT_EQ("atrue", valueOf<std::string>(apply(constant(std::string("a")), "+", constant(true))));
    EXPECT_TRUE(valueOf<bool>(apply(constant(std::string("a")), "<", constant(std::string("b")))));
    EXPECT_TRUE(valueOf<bool>(apply(constant(true), "||", constant(false))));
    EXPECT_FALSE(valueOf<bool>(apply("!", constant(true))));
    EXPECT_TRUE(valueOf<bool>(apply(constant(NewData), "==", constant(NewData))));
}

TEST_F(BuiltinTypes, CopiesOfAnExpressionHaveTheirOwnResult) {
    auto number = variable(1);
    const SourcePtr sum = apply(number, "+", constant(1));
    internal::CopyMap copies;
    const SourcePtr copied(sum->copy(copies));
    EXPECT_EQ(2, valueOf<int>(copied));
    EXPECT_NE(sum->getRawConstPointer(), copied->getRawConstPointer());
}

TEST_F(BuiltinTypes, UsersAddOperatorsAndConstructors) {
    types::operators()->add(types::newBinaryOperator("**", [](double base, int power) {
        double result = 1;
        while (power-- > 0) result *= base;
        return result;
    }));
    EXPECT_EQ(8.0, valueOf<double>(apply(constant(2.0), "**", constant(3))));
    // Types are shared by all tests, so the new conversion is one that nobody asks for.
    type("WriteStatus")->addConstructor(types::newConstructor([](const std::string&) { return NotConnected; }));
    EXPECT_EQ(NotConnected, valueOf<WriteStatus>(construct("WriteStatus", {constant(std::string("none"))})));
}

TEST_F(BuiltinTypes, UsersAddTernaryAndDotOperators) {
    struct Between : std::ternary_function<double, double, double, bool> {
        bool operator()(double low, double value, double high) const { return low < value && value < high; }
    };
    types::operators()->add(types::newTernaryOperator("<<", Between()));
    const SourcePtr low = constant(1.0), high = constant(3.0), number = constant(2);
    const SourcePtr made = types::operators()->applyTernary("<<", low.get(), number.get(), high.get());
    EXPECT_TRUE(valueOf<bool>(made)) << "the second and third are converted";
    types::operators()->add(types::newDotOperator("half", [](double value) { return value / 2; }));
    EXPECT_EQ(1.5, valueOf<double>(high->getMember("half")));
    EXPECT_EQ(nullptr, high->getMember("third"));
}

TEST_F(BuiltinTypes, Globals) {
    const auto globals = types::GlobalsRepository::Instance();
    for (const char* name : {"NewData", "CollectFailure", "BUFFER", "UNBUFFERED", "LOCK_FREE", "PerOutputPort",
                             "ORO_SCHED_RT", "ORO_WAIT_REL"}) {
        ASSERT_TRUE(globals->hasAttribute(name)) << name;
        EXPECT_FALSE(globals->getAttribute(name)->getDataSource()->isAssignable()) << name;
    }
    ASSERT_TRUE(globals->hasAttribute("DefaultConnPolicy"));
    EXPECT_EQ(&ConnPolicy::Default(), globals->getAttribute("DefaultConnPolicy")->getDataSource()->getRawPointer());
}

TEST_F(BuiltinTypes, PolicyMembersCanBeSet) {
    auto policy = variable(ConnPolicy::data());
    ASSERT_TRUE(policy->getMember("size")->update(variable(12).get()));
    EXPECT_EQ(12, policy->rvalue().size);
    ASSERT_TRUE(policy->getMember("name_id")->update(variable("topic").get()));
    EXPECT_EQ("topic", policy->rvalue().name_id);
    EXPECT_EQ((std::vector<std::string>{"type", "size", "lock_policy", "init", "pull", "buffer_policy", "mandatory",
                                        "transport", "data_size", "name_id"}),
              policy->getMemberNames());  // max_threads is not one of them
}

TEST_F(BuiltinTypes, RealTimeStringsArePrintedReadAndIndexed) {
    auto text = variable(rt_string("two words"));
    EXPECT_EQ("two words", text->toString());
    EXPECT_TRUE(type("rt_string")->fromString("three short words", text));
    EXPECT_EQ("three short words", text->get());
    EXPECT_EQ(17, valueOf<int>(text->getMember("size")));
    EXPECT_EQ('h', valueOf<char>(text->getMember("1")));
    EXPECT_TRUE(type("rt_string")->resize(text, 5));
    EXPECT_EQ("three", text->get());
}

TEST_F(BuiltinTypes, RealTimeStringsAreConstructedFromSizesAndStrings) {
    EXPECT_EQ(20u, valueOf<rt_string>(construct("rt_string", {constant(20)})).size());
    EXPECT_EQ(nullptr, construct("rt_string", {constant(1.5f), constant(2)}));
    EXPECT_EQ("abc", valueOf<rt_string>(construct("rt_string", {constant(std::string("abc"))})));
    EXPECT_EQ("abc", valueOf<std::string>(construct("string", {constant(rt_string("abc"))})));
    auto text = variable("");
    EXPECT_TRUE(text->update(type("string")->convert(variable(rt_string("xyz"))).get()));
    EXPECT_EQ("xyz", text->get());
}

TEST_F(BuiltinTypes, OperatorsOfRealTimeStrings) {
    const rt_string a("a");
    EXPECT_EQ("ab", valueOf<rt_string>(apply(constant(a), "+", constant(rt_string("b")))));
    EXPECT_EQ("ab", valueOf<rt_string>(apply(constant(a), "+", constant(std::string("b")))));
    EXPECT_EQ("a-1", valueOf<rt_string>(apply(constant(a), "+", constant(-1))));
    EXPECT_EQ("a4000000000", valueOf<rt_string>(apply(constant(a), "+", constant(4000000000u))));
    EXPECT_EQ("a0.1", valueOf<rt_string>(apply(constant(a), "+", constant(0.1))));
    EXPECT_EQ("a1e-10", valueOf<rt_string>(apply(constant(a), "+", constant(1e-10f))));
    EXPECT_EQ("afalse", valueOf<rt_string>(apply(constant(a), "+", constant(false))));
    EXPECT_EQ("ac", valueOf<rt_string>(apply(constant(a), "+", constant('c'))));
    EXPECT_TRUE(valueOf<bool>(apply(constant(a), "<", constant(rt_string("b")))));
    EXPECT_TRUE(valueOf<bool>(apply(constant(a), "!=", constant(rt_string("b")))));
    // The right-hand side is converted; the left-hand side decides.
    EXPECT_TRUE(valueOf<bool>(apply(constant(a), "==", constant(std::string("a")))));
}

TEST_F(BuiltinTypes, ExpressionsOfRealTimeStringsFailWhenTheMemoryIsUsedUp) {
    const SourcePtr joined = apply(variable(rt_string(3000, 'a')), "+", variable(rt_string(3000, 'b')));
    const SourcePtr constructed = construct("rt_string", {variable(std::string(5000, 'c'))});
    std::vector<char> memory(11000);  // its bookkeeping takes most of it
    ASSERT_GT(init_memory_pool(memory.size(), memory.data()), 1000u);
    EXPECT_FALSE(joined->evaluate());
    EXPECT_FALSE(constructed->evaluate());
    destroy_memory_pool(memory.data());
    EXPECT_TRUE(joined->evaluate());
    EXPECT_TRUE(constructed->evaluate());
}
