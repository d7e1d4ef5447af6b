// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Expressions as scripts have them: operators and conversions of the built-in types are evaluated without the heap.
#include <support/real_time_trap.hpp>
#include <unit/types/builtin_typekit.hpp>

#include <rtt/rt_string.hpp>
#include <rtt/types/OperatorTypes.hpp>

using namespace RTT;
using namespace types_test;
using oroforge::test::expectRealTime;
using oroforge::test::RealTimeTrap;

namespace {

class RealTimeExpressions : public WithBuiltinTypes {
protected:
    void SetUp() override { OROFORGE_NEEDS_REAL_TIME_TRAP(); }
};

SourcePtr apply(const SourcePtr& a, const char* op, const SourcePtr& b) {
    return types::operators()->applyBinary(op, a.get(), b.get());
}

}  // namespace

TEST_F(RealTimeExpressions, OfNumbers) {
    auto a = variable(1), b = variable(2);
    const SourcePtr sum = apply(apply(a, "+", b), "*", type("int")->convert(variable(3u)));
    ASSERT_TRUE(sum && sum->evaluate());
    expectRealTime([&] {
        a->set(4);
        EXPECT_TRUE(sum->evaluate());
    });
    EXPECT_EQ(18, valueOf<int>(sum));
}

TEST_F(RealTimeExpressions, OfRealTimeStrings) {
    auto text = variable(rt_string("a text of more than fifteen characters"));
    const SourcePtr sum = apply(apply(text, "+", variable(5.5)), "+", variable(7));
    ASSERT_TRUE(sum && sum->evaluate());
    const unsigned all = RealTimeTrap::kEverything;
    expectRealTime([&] { EXPECT_TRUE(sum->evaluate()); }, all & ~unsigned(RealTimeTrap::kLock));
    EXPECT_EQ("a text of more than fifteen characters5.57", valueOf<rt_string>(sum));
}
