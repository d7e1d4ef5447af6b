// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Headers that are nested so deeply that a compiler runs out of stack.
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace oroforge::test {
namespace {

std::string times(int count, const std::string& text) {
    std::string all;
    for (int i = 0; i != count; ++i) all += text;
    return all;
}

std::string classes(int depth) {
    std::string text;
    for (int i = 0; i != depth; ++i) text += "struct S" + std::to_string(i) + " { ";
    return text + "int x;" + times(depth, " };");
}

std::string alias(int depth) {
    std::string text = "template <class T> struct A { T x; };\nusing T0 = int;\n";
    for (int i = 0; i != depth; ++i) text += "using T" + std::to_string(i + 1) + " = A<T" + std::to_string(i) + ">;\n";
    return text + "struct U { T" + std::to_string(depth) + " x; };";
}

const std::string kTemplate = "template <class T> struct A { T x; };\n";
const std::string kInstances = "recursive template instantiation exceeded maximum depth of 1024";
const std::string kBrackets = "bracket nesting level exceeded maximum of 256";
const std::string kWords = "more than 20000 words before the next ',', ';' or brace";

struct Case {
    const char* name;
    std::string text;
    std::string error;
};

const Case kCases[] = {
    {"instances", "template <int N> struct D { D<N - 1> x; };\ntemplate <> struct D<0> {};\nstruct U { D<2000> d; };",
     kInstances},
    {"arguments", kTemplate + "struct U { " + times(2000, "A<") + "int" + times(2000, ">") + " x; };", kInstances},
    {"arguments_far", kTemplate + "struct U { " + times(200000, "A<") + "int" + times(200000, ">") + " x; };",
     "template arguments are nested more than 4000 deep"},
    {"aliases", alias(2000), kInstances},
    {"classes", classes(2000), kBrackets},
    {"namespaces", times(2000, "namespace n { ") + "struct U { int x; };" + times(2000, " }"), kBrackets},
    {"parentheses", "struct U { int x = " + times(2000, "(") + "1" + times(2000, ")") + "; };", kBrackets},
    {"functions", "struct U { int " + times(2000, "(") + "x" + times(2000, ")") + "(); };", kBrackets},
    {"pointers", "struct U { int " + times(2000, "*") + " x; };", "is a raw pointer"},
    {"pointers_far", "struct U { int " + times(50000, "*") + " x; };", kWords},
    {"signs", "struct U { int x = " + times(50000, "- ") + "1; };", kWords},
    {"casts", "struct U { int x = " + times(20000, "(int)") + "1; };", kWords},
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class DeepNesting : public testing::TestWithParam<Case> {
protected:
    Outcome run(const char* program, std::vector<std::string> arguments) {
        dir_.write("deep.hpp", "#pragma once\n" + GetParam().text + "\n");
        Command command;
        command.program = program;
        command.directory = dir_.path();
        command.arguments = std::move(arguments);
        return test::run(command);
    }

    const TempDir dir_;
};

}  // namespace

TEST_P(DeepNesting, IsALocatedErrorOfTypegen) {
    const Outcome outcome = run(TYPEGEN, {"-o", "out", "demo", "deep.hpp"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err.compare(0, 9, "deep.hpp:"), 0) << outcome.err.substr(0, 200);
    EXPECT_NE(outcome.err.find(GetParam().error), std::string::npos) << outcome.err.substr(0, 2000);
}

TEST_P(DeepNesting, DoesNotEndDescribe) {
    const Outcome outcome = run(OROCREATE_PKG, {"--describe", "deep.hpp"});
    // Its components are what is asked for: a deep pointer is no fault.
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("error: "), std::string::npos) << outcome.err.substr(0, 200);
}

INSTANTIATE_TEST_SUITE_P(Of, DeepNesting, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(LongTexts, OfManyLiteralsAndElementsAreRead) {
    const TempDir dir;
    dir.write("long.hpp", "#pragma once\nconstexpr char kText[] = " + times(30000, "\"0123456789\"\n") +
                              ";\nconstexpr int kTable[] = {" + times(30000, "1, ") + "0};\nstruct A { int a; };\n");
    Command command;
    command.program = TYPEGEN;
    command.directory = dir.path();
    command.arguments = {"-o", "out", "demo", "long.hpp"};
    EXPECT_EQ(run(command).err, "");
}

}  // namespace oroforge::test
