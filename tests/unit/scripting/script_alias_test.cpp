// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What an alias stands for, wherever it is used.
#include "script_fixture.hpp"

using namespace RTT;

namespace {

class Aliases : public ScriptTest {
protected:
    Aliases() : arm("arm") {
        arm.addAttribute("level", level);
        component.addOperation("count", [this] { return ++counted; });
        component.connectPeers(&arm);
    }

    /** A chain in which each alias has the one before it twice. */
    static std::string doubled(int length) {
        std::string script = "var int x = 1\nalias int a0 = x\n";
        for (int i = 1; i <= length; ++i) {
            const std::string before = "a" + std::to_string(i - 1);
            script += "alias int a" + std::to_string(i) + " = " + before + " + " + before + "\n";
        }
        return script;
    }

    double level = 2.5;
    int counted = 0;
    TaskContext arm;
};

}  // namespace

TEST_F(Aliases, NamesOfLaterVariablesDoNotChangeThem) {
    int attribute = 3;
    component.addAttribute("x", attribute);
    ASSERT_TRUE(run("alias int twice = x * 2\nvar int x = 50\nvar int seen = twice")) << messages();
    EXPECT_EQ(value<int>("seen"), 6);
}

TEST_F(Aliases, NamesOfLaterVariablesDoNotChangeThemInAProgram) {
    ASSERT_TRUE(
        run("var int x = 5, seen, own\n"
            "program p {\n alias int twice = x * 2\n var int x = 50\n seen = twice\n own = x\n}"))
        << messages();
    EXPECT_EQ(value<int>("seen"), 10);
    EXPECT_EQ(value<int>("own"), 50);
}

TEST_F(Aliases, VariablesOfWhoUsesThemDoNotChangeThem) {
    ASSERT_TRUE(
        run("var int x = 5, seen\nalias int twice = x * 2\nalias int more = twice + x\n"
            "program p {\n var int x = 50, twice = 70\n seen = more + x\n}"))
        << messages();
    EXPECT_EQ(value<int>("seen"), 65);
}

TEST_F(Aliases, EachUseComputesThem) {
    ASSERT_TRUE(run("alias int n = count()\nvar int sum = n + n + n")) << messages();
    EXPECT_EQ(value<int>("sum"), 6);
    EXPECT_EQ(counted, 3);
}

TEST_F(Aliases, OfOthersMayBeUsedTwice) {
    ASSERT_TRUE(run(doubled(8) + "var int all = a8")) << messages();
    EXPECT_EQ(value<int>("all"), 256);
}

TEST_F(Aliases, ThatGrowWithoutEndAreAnError) {
    EXPECT_FALSE(run(doubled(60)));
    EXPECT_EQ(
        messages(),
        "script.ops:16:17: error: [OPS131] alias 'a13' is made of more than 10000 others; assign one of them to a "
        "variable, and use that\n");
}

TEST_F(Aliases, ALongChainOfThemIsAnError) {
    std::string script = "alias int a0 = 1\n";
    for (int i = 1; i <= 100; ++i)
        script += "alias int a" + std::to_string(i) + " = a" + std::to_string(i - 1) + " + 1\n";
    EXPECT_FALSE(run(script));
    EXPECT_NE(messages().find("[OPS131]"), std::string::npos) << messages();
}

TEST_F(Aliases, ErrorsWithinThemAreToldInTheirFile) {
    ASSERT_TRUE(run("alias double l = 2.0 * arm.level")) << messages();
    component.removePeer("arm");
    // A script that this one runs.
    using namespace RTT::scripting::detail;
    oroforge::diag::Sink found;
    const ast::Script inner = parse("\nvar double seen = l + 1.0", "inner.ops", found);
    Scope innerScope("the inner script", &scope);
    CompileContext where = context();
    where.file = "inner.ops";
    where.sink = &found;
    EXPECT_EQ(Compiler(where).statement(*std::get<ast::StatementPtr>(inner.items[0].what), innerScope), nullptr);
    ASSERT_EQ(found.all().size(), 1u);
    EXPECT_EQ(toString(found.all()[0]),
              "script.ops:1:24: error: [OPS133] component 'robot' has no peer, service or value 'arm'");
    ASSERT_EQ(found.all()[0].notes.size(), 1u);
    EXPECT_EQ(toString(found.all()[0].notes[0].where), "inner.ops:2:19");
    EXPECT_EQ(found.all()[0].notes[0].message, "alias 'l' is used here");
}
