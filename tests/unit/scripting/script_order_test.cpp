// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In what order the parts of an expression are read and executed, and how long it may be.
#include "script_fixture.hpp"

#include <limits>
#include <string>
#include <vector>

using namespace RTT;

namespace {

class Order : public ScriptTest {
protected:
    Order() {
        component.addAttribute("x", x);
        component.addAttribute("s", s);
        component.addAttribute("v", v);
        component.addOperation("f", [this] { return x = 10, s = "new", 1; });
        component.addOperation("g", [this] { return s = "new", std::string("g"); });
        component.addOperation("h", [this] { return s + "h"; });
        component.addOperation("next", [this] { return ++x; });
        component.addOperation("refill", [this] { return v[0] = 7; });
        component.addOperation("count", [this] { return ++x, std::string("counted"); });
        component.addOperation("half", [](int a, double b) { return a + b / 2; });
        component.addOperation("pair", [](int a, int b) { return 10 * a + b; });
        component.addOperation("join", [](const std::string& a, const std::string& b) { return a + b; });
        component.addOperation("exchange", [](int& a, int& b, int) { std::swap(a, b); });
    }
    std::size_t sizeOf(const std::string& statement) {
        using namespace RTT::scripting::detail;
        oroforge::diag::Sink found;
        const ast::Script tree = parse(statement, "script.ops", found);
        const auto code = Compiler(context()).statement(*std::get<ast::StatementPtr>(tree.items[0].what), scope);
        return code ? code->size() : 0;
    }
    static std::string repeated(const std::string& text, int times) {
        std::string result;
        for (int i = 0; i < times; ++i) result += text;
        return result;
    }

    int x = 2;
    std::string s = "old";
    std::vector<double> v{1, 2};
};

}  // namespace

TEST_F(Order, TheLeftOperandIsReadBeforeTheRightOneIsExecuted) {
    EXPECT_EQ(result<int>("int", "x + f()"), 3);
    x = 2;
    EXPECT_EQ(result<int>("int", "x * 2 - f() - x"), -7);
    x = 2;
    EXPECT_FALSE(result<bool>("bool", "x > f() + 2"));
    x = 2;
    EXPECT_EQ(result<int>("int", "x + (x + f())"), 5);
    x = 2;
    EXPECT_EQ(result<int>("int", "x + (x = 30)"), 32);
}

TEST_F(Order, AlsoWithFunctionsAndAliases) {
    ASSERT_TRUE(run("int change() { x = 10\n return 1 }\nvar int y = x + change()")) << messages();
    EXPECT_EQ(value<int>("y"), 3);
    ASSERT_TRUE(run("x = 2\nalias int changed = change()\nvar int z = x + changed")) << messages();
    EXPECT_EQ(value<int>("z"), 3);
    ASSERT_TRUE(run("x = 2\nvar int w = x + f")) << messages();
    EXPECT_EQ(value<int>("w"), 3);
}

TEST_F(Order, AlsoTexts) {
    EXPECT_EQ(result<std::string>("string", "s + g()"), "oldg");
    ASSERT_TRUE(run("s = \"old\"\nstring change() { s = \"new\"\n return \"c\" }\nvar string t = s + change()"))
        << messages();
    EXPECT_EQ(value<std::string>("t"), "oldc");
    ASSERT_TRUE(run("s = \"old\"\nt = h() + change() + s")) << messages();
    EXPECT_EQ(value<std::string>("t"), "oldhcnew");
    x = 2;
    ASSERT_TRUE(run("t = count() + (x + 1)")) << messages();
    EXPECT_EQ(value<std::string>("t"), "counted4");
    ASSERT_TRUE(run("s = \"old\"\nvar bool same = s == h()")) << messages();
    EXPECT_FALSE(value<bool>("same"));
}

TEST_F(Order, ArgumentsAreTakenFromLeftToRight) {
    EXPECT_EQ(result<int>("int", "pair(x, f())"), 21);
    EXPECT_EQ(x, 10);
    x = 2;
    EXPECT_EQ(result<int>("int", "pair(x, x = 3)"), 23);
    EXPECT_EQ(result<int>("int", "pair(x = 4, x)"), 44);
    EXPECT_EQ(result<int>("int", "pair(next(), next())"), 56);
    EXPECT_EQ(result<int>("int", "pair(pair(x, next()), x)"), 677);
    EXPECT_EQ(result<int>("int", "pair(f() * 2, x)"), 30);
    x = 2;
    EXPECT_EQ(result<int>("int", "pair(f(), x + 1)"), 21) << "what is computed comes after the call, too";
    x = 2;
    EXPECT_EQ(result<double>("double", "half(f(), x)"), 6.0) << "and what is converted";
    s = "old";
    EXPECT_EQ(result<std::string>("string", "join(s, g())"), "oldg");
    EXPECT_EQ(result<std::string>("string", "join(h(), (s = \"last\"))"), "newhlast");
    EXPECT_EQ(result<std::vector<double>>("array", "array(v[0], refill(), v[0])"), (std::vector<double>{1, 7, 7}));
}

TEST_F(Order, ArgumentsOfFunctionsAreTakenFromLeftToRight) {
    ASSERT_TRUE(
        run("int twice(int a, int b) { return 10 * a + b }\nint changed() { x = x + 1\n return 1 }\n"
            "string both(string a, string b) { return a + b }\nstring renamed() { s = \"new\"\n return \"r\" }"))
        << messages();
    EXPECT_EQ(result<int>("int", "twice(x, changed())"), 21);
    EXPECT_EQ(result<int>("int", "pair(next(), changed())"), 41) << "an operation before a function";
    EXPECT_EQ(result<int>("int", "twice(next(), next())"), 67);
    EXPECT_EQ(result<std::string>("string", "both(s, renamed())"), "oldr");
    s = "old";
    EXPECT_EQ(result<std::string>("string", "both(s + s, renamed() + s)"), "oldoldrnew");
}

TEST_F(Order, WhatAnOperationChangesStaysAVariable) {
    ASSERT_TRUE(run("var int y = 1, z = 2\nexchange(y, z, f())")) << messages();
    EXPECT_EQ(value<int>("y"), 2);
    EXPECT_EQ(value<int>("z"), 1);
}

TEST_F(Order, OnlyArgumentsBeforeCallsAreCopied) {
    ASSERT_TRUE(run("var int a = 1, b = 2, c = 3"));
    EXPECT_EQ(sizeOf("c = pair(a, b)"), 2u) << "a call, and the end";
    EXPECT_EQ(sizeOf("c = pair(f(), b)"), 2u);
    EXPECT_EQ(sizeOf("c = pair(a, f())"), 3u) << "a copy besides";
    EXPECT_EQ(sizeOf("c = pair(7, f())"), 2u);
    EXPECT_EQ(sizeOf("c = pair(a, pair(f(), f()))"), 4u);
}

TEST_F(Order, OnlyCallsCostACopy) {
    ASSERT_TRUE(run("var int a = 1, b = 2, c = 3"));
    EXPECT_EQ(sizeOf("c = a + b * a"), 3u) << "two operations, and the end";
    EXPECT_EQ(sizeOf("c = a + f()"), 4u) << "a copy, the call, the sum, and the end";
    EXPECT_EQ(sizeOf("c = a * b + f()"), 4u) << "what was computed needs none";
    EXPECT_EQ(sizeOf("c = 3 + f()"), 3u);
}

TEST_F(Order, LongChainsOfNumbers) {
    EXPECT_EQ(result<int>("int", "1" + repeated(" + 1", 5000)), 5001);
    EXPECT_EQ(result<double>("double", "1.0" + repeated(" * 2 - 1", 20000)), 2.0 - 2.0 * 19999 - 1.0);
    EXPECT_TRUE(result<bool>("bool", "true" + repeated(" && x == x", 5000)));
}

TEST_F(Order, LongChainsOfTexts) {
    EXPECT_EQ(result<std::string>("string", "\"a\"" + repeated(" + x", 20000)), "a" + repeated("2", 20000));
}

TEST_F(Order, ErrorsInLongChainsAreToldWhereTheyAre) {
    EXPECT_FALSE(run("x = 1" + repeated(" + 1", 300) + " + v"));
    EXPECT_EQ(messages(), "script.ops:1:1207: error: [OPS126] operator '+' does not exist for types int and array\n");
}

TEST_F(Order, TheLeastNumbersAreNumbers) {
    EXPECT_EQ(result<int>("int", "-2147483648"), std::numeric_limits<int>::min());
    EXPECT_EQ(result<int>("int", "-2147483648 + 1"), std::numeric_limits<int>::min() + 1);
    EXPECT_EQ(result<int>("int", "-2147483648 / -1"), std::numeric_limits<int>::min());
    EXPECT_EQ(result<long long>("llong", "-9223372036854775808ll"), std::numeric_limits<long long>::min());
}
