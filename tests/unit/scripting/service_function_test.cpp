// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions that scripts define: what is said of them, and how many there may be.
#include "service_host.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>

namespace {

using service_test::ServiceTest;
using testing::HasSubstr;
using testing::IsEmpty;

class FunctionsOfService : public ServiceTest {
protected:
    typedef RTT::OperationCaller<int(int)> Caller;

    Caller caller(const std::string& name) {
        return Caller(host.getOperation(name), RTT::internal::GlobalEngine::Instance());
    }
    /** Each calls the one before. */
    static std::string chain(int length, const std::string& name) {
        std::string script = "int " + name + "0(int i) { return i }\n";
        for (int i = 1; i != length; ++i)
            script += (i + 1 == length ? "export int " : "int ") + name + std::to_string(i) + "(int i) { return " +
                      name + std::to_string(i - 1) + "(i) + 1 }\n";
        return script;
    }
    static double secondsOf(const std::function<bool()>& action) {
        const std::clock_t begin = std::clock();
        EXPECT_TRUE(action());
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    }
};

TEST_F(FunctionsOfService, WarningsOfThemAreGivenOnce) {
    EXPECT_TRUE(eval("export int f(int i) {\n  var int k = 2.5\n  return string(i).size + k\n}"));
    EXPECT_THAT(logged(), HasSubstr("eval():2:15: warning: [OPS120]"));
    auto first = caller("f"), second = caller("f"), third = caller("f");
    ASSERT_TRUE(first.ready() && second.ready() && third.ready());
    EXPECT_EQ(5, third(3));
    EXPECT_TRUE(eval("var int a = f(1) + this.f(2)\nexport int g(int i) { return f(i) + this.f(i) + this.f(i) }"));
    EXPECT_TRUE(eval("count = g(1) + this.g(2)"));
    EXPECT_THAT(logged(), IsEmpty());
}

TEST_F(FunctionsOfService, ConstantsInThemAreComputedByOtherFunctions) {
    EXPECT_TRUE(
        eval("int n() {\n  count = count + 1\n  return 2\n}\n"
             "export int f(int i) {\n  const int c = 6 / n()\n  var array v(n())\n  return c + v.size + i\n}"));
    EXPECT_THAT(logged(), IsEmpty());
    EXPECT_EQ(2, host.count) << "computed once each";
    EXPECT_TRUE(eval("count = f(1)"));
    EXPECT_EQ(6, host.count);
    EXPECT_TRUE(eval("int none() { return 0 }\nvoid g() { var array v(none()) }"));
    EXPECT_THAT(logged(), HasSubstr("[OPS115]"));
}

TEST_F(FunctionsOfService, MayCallEachOtherInALongChain) {
    ASSERT_TRUE(eval(chain(4000, "f")));
    auto last = caller("f3999");
    ASSERT_TRUE(last.ready());
    EXPECT_EQ(3999 + 7, last(7));
    EXPECT_TRUE(eval("count = f3999(1)"));
    EXPECT_EQ(4000, host.count);
    EXPECT_THAT(logged(), IsEmpty());
}

/// Four times as many take four times as long; sixteen times would be quadratic.
TEST_F(FunctionsOfService, TimeToDefineThemGrowsWithTheirNumber) {
    const double few = std::max(secondsOf([&] { return eval(chain(500, "few")); }), 1e-3);
    const double many = secondsOf([&] { return eval(chain(2000, "many")); });
    EXPECT_LT(many / few, 9) << many << " s and " << few << " s";
}

TEST_F(FunctionsOfService, OfALongChainAreCheckedWhereTheyAreDefined) {
    EXPECT_FALSE(eval(chain(300, "f") + "int wrong(int i) { return f299(i, 1) }\n"));
    EXPECT_THAT(logged(), HasSubstr("[OPS142] 'f299' expects 1 argument, found 2 arguments"));
}

TEST_F(FunctionsOfService, CannotBeCalledBeforeTheyAreDefined) {
    EXPECT_FALSE(eval("count = 1\nvoid early() {\n  count = 2\n  late()\n}\nvoid late() { count = 3 }\n"));
    EXPECT_EQ(
        "eval():4:3: error: [OPS134] component 'host' has no operation 'late' yet: the function is defined "
        "later, in line 6\n"
        "  late()\n"
        "  ^\n",
        logged());
    EXPECT_EQ(1, host.count);
    EXPECT_FALSE(eval("laet()\nvoid late() { }\n"));
    EXPECT_THAT(logged(), HasSubstr("has no operation 'laet'\n"));
}

TEST_F(FunctionsOfService, DoNotSeeWhatIsDeclaredAfterThem) {
    EXPECT_TRUE(eval("export int f(int i) { return i + count }\ncount = 5\nvar int count = 100\nhost.count = f(1)\n"));
    EXPECT_EQ(6, host.count);
    auto first = caller("f"), second = caller("f");
    EXPECT_EQ(7, first(1));
    EXPECT_EQ(7, second(1));
}

}  // namespace
