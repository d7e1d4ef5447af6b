// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operators and conversions of numbers and truth values, and that they agree with what typekits register for them.
#include "script_fixture.hpp"

#include <rtt/internal/DataSources.hpp>
#include <rtt/scripting/detail/compile/arithmetic.hpp>
#include <rtt/scripting/detail/compile/kinds.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/Types.hpp>

#include <limits>

using namespace RTT;
using namespace RTT::scripting::detail;

namespace {

class Arithmetic : public ScriptTest {};

base::DataSourceBase::shared_ptr sample(Kind kind) {
    return withType(kind, [](auto type) -> base::DataSourceBase::shared_ptr {
        typedef typename decltype(type)::type T;
        return new internal::ValueDataSource<T>(static_cast<T>(3));
    });
}

Kind kindAt(int index) { return static_cast<Kind>(index); }

}  // namespace

TEST_F(Arithmetic, HasTheOperatorsThatTheTypekitHas) {
    for (const char* op : {"+", "-", "*", "/", "%", "<", ">", "<=", ">=", "==", "!=", "&&", "||"}) {
        for (int i = 0; i != kDirectKinds; ++i) {
            const auto operand = sample(kindAt(i));
            const base::DataSourceBase::shared_ptr registered =
                types::operators()->applyBinary(op, operand.get(), operand.get());
            // Those of char are applied to char only; conversions are the subject of the next test.
            EXPECT_EQ(binaryOperation(op, kindAt(i)).act != nullptr, registered != nullptr)
                << op << " of " << operand->getTypeName();
            if (registered) {
                EXPECT_EQ(binaryOperation(op, kindAt(i)).result, kindOf(*registered)) << op << i;
            }
        }
    }
}

TEST_F(Arithmetic, HasTheConversionsThatTheTypekitHas) {
    for (int from = 0; from != kDirectKinds; ++from) {
        for (int to = 0; to != kDirectKinds; ++to) {
            const auto source = sample(kindAt(from)), target = sample(kindAt(to));
            const auto converted = target->getTypeInfo()->convert(source);
            const bool possible = converted && kindOf(*converted) == kindAt(to);
            EXPECT_EQ(conversion(kindAt(from), kindAt(to)) != Conversion::None, possible)
                << source->getTypeName() << " to " << target->getTypeName();
        }
    }
}

TEST_F(Arithmetic, TheFirstOperandDecides) {
    EXPECT_EQ(result<int>("int", "1 + 2.5"), 3);
    EXPECT_EQ(result<double>("double", "1.0 + 2"), 3.0);
    EXPECT_EQ(result<double>("double", "2.5 + 1"), 3.5);
    EXPECT_EQ(result<unsigned>("uint", "7u - 2"), 5u);
}

TEST_F(Arithmetic, LosingTheFractionIsWarnedOf) {
    ASSERT_TRUE(run("var int i = 1 + 2.5"));
    EXPECT_EQ(messages(),
              "script.ops:1:17: warning: [OPS120] a value of type double is converted to int and loses its fraction\n");
}

TEST_F(Arithmetic, Numbers) {
    EXPECT_EQ(result<int>("int", "7 / 2"), 3);
    EXPECT_EQ(result<int>("int", "-7 % 4"), -3);
    EXPECT_EQ(result<double>("double", "7.0 / 2"), 3.5);
    EXPECT_EQ(result<int>("int", "2 + 3 * 4 - 1"), 13);
    EXPECT_EQ(result<int>("int", "(2 + 3) * -4"), -20);
    EXPECT_EQ(result<int>("int", "0x10 + 1u"), 17);
    EXPECT_EQ(result<long long>("llong", "4000000000ll * 4"), 16000000000ll);
    EXPECT_EQ(result<int>("int", "2147483647 + 1"), std::numeric_limits<int>::min());
    EXPECT_EQ(result<float>("float", "1.5f * 2.0f"), 3.0f);
}

TEST_F(Arithmetic, Truth) {
    EXPECT_TRUE(result<bool>("bool", "1 < 2 && 2.0 >= 2"));
    EXPECT_FALSE(result<bool>("bool", "!(true || false)"));
    EXPECT_TRUE(result<bool>("bool", "true != false"));
    EXPECT_TRUE(result<bool>("bool", "'a' < 'b'"));
    // || binds more tightly than &&.
    EXPECT_FALSE(result<bool>("bool", "false && false || true"));
}

TEST_F(Arithmetic, DivisionByZeroFailsTheStatement) {
    EXPECT_FALSE(run("var int n = 0\nvar int q = 5\nq = 1 / n"));
    EXPECT_EQ(messages(), "script.ops:3:1: error: [OPS400] division by zero\n");
    EXPECT_EQ(value<int>("q"), 5);
    EXPECT_FALSE(run("q = 1 % n"));
    EXPECT_EQ(messages(), "script.ops:1:1: error: [OPS400] remainder of a division by zero\n");
}

TEST_F(Arithmetic, TypesWithoutThatOperator) {
    EXPECT_FALSE(run("var int x = true * 2"));
    EXPECT_EQ(messages(), "script.ops:1:18: error: [OPS126] operator '*' does not exist for types bool and int\n");
    EXPECT_FALSE(run("var bool b = !\"text\""));
    EXPECT_EQ(messages(), "script.ops:1:14: error: [OPS125] operator '!' does not exist for type string\n");
    EXPECT_FALSE(run("var double d = 1.5 % 2.0"));
    EXPECT_EQ(messages(), "script.ops:1:20: error: [OPS126] operator '%' does not exist for types double and double\n");
}
