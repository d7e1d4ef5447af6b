// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/options.hpp>

#include <cstdlib>

#include <gtest/gtest.h>

using namespace oroforge;
using typekit::Options;

namespace {

Options parsed(const std::vector<std::string>& words) {
    diag::Sink sink;
    const auto options = typekit::parseOptions(words, sink);
    EXPECT_TRUE(options) << (sink.empty() ? "" : sink.all()[0].message);
    return options.value_or(Options{});
}

std::vector<std::string> errorsOf(const std::vector<std::string>& words) {
    diag::Sink sink;
    EXPECT_FALSE(typekit::parseOptions(words, sink));
    std::vector<std::string> messages;
    for (const auto& diagnostic : sink.all()) messages.push_back(diagnostic.message);
    return messages;
}

}  // namespace

TEST(Options, TakeAllSpellingsOfAValue) {
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"-o", "out", "n", "h"}, {"-oout", "n", "h"}, {"--output=out", "n", "h"}, {"n", "h", "--output", "out"}}) {
        EXPECT_EQ(parsed(words).output, "out");
    }
    EXPECT_EQ(parsed({"n", "h"}).output, "./n");
}

TEST(Options, PassOnWhatChangesTheMeaningOfHeaders) {
    const Options options =
        parsed({"-Ia", "-I", "b", "-DX=1", "-UY", "-isystem", "c", "-include", "d", "-std=c++20", "n", "h"});
    EXPECT_EQ(options.flags, (std::vector<std::string>{"-I", "a", "-I", "b", "-D", "X=1", "-U", "Y", "-isystem", "c",
                                                       "-include", "d", "-std=c++20"}));
}

TEST(Options, TakeTheTargetFromTheEnvironment) {
    ::setenv("OROCOS_TARGET", "xenomai", 1);
    EXPECT_EQ(parsed({"n", "h"}).target, "xenomai");
    ::unsetenv("OROCOS_TARGET");
    EXPECT_EQ(parsed({"n", "h"}).target, "gnulinux");
}

TEST(Options, AllowSwitchingTransportsOff) {
    EXPECT_TRUE(parsed({"--notransports=corba,mqueue", "-t", "", "n", "h"}).transports.empty());
    EXPECT_TRUE(parsed({"-t", "corba", "-n", "corba", "n", "h"}).transports.empty());
    EXPECT_EQ(parsed({"n", "h"}).transports, (std::vector<std::string>{"corba", "mqueue"}));
    EXPECT_EQ(parsed({"-t", "mqueue,corba", "n", "h"}).transports, (std::vector<std::string>{"mqueue", "corba"}));
}

TEST(Options, RefuseTransportsThatAreNotInstalled) {
    diag::Sink sink;
    EXPECT_FALSE(typekit::parseOptions({"-t", "ros,nope", "n", "h"}, sink));
    ASSERT_EQ(sink.all().size(), 2U);
    EXPECT_EQ(sink.all()[0].code, "TK068");
    EXPECT_EQ(sink.all()[0].message,
              "transport 'ros' is not part of this toolchain's installation; installed: corba, mqueue, known: corba, "
              "mqueue, ros, typelib");
    EXPECT_EQ(sink.all()[1].code, "TK003");
    EXPECT_EQ(
        errorsOf({"-n", "mqeue", "n", "h"}),
        (std::vector<std::string>{"unknown transport 'mqeue', expected 'corba', 'mqueue', 'ros' or 'typelib'; did "
                                  "you mean 'mqueue'?"}));
}

TEST(Options, CheckWritesNothing) {
    EXPECT_EQ(parsed({"-o", "a b", "--check", "n", "it's"}).refresh, "to refresh: typegen -o 'a b' n 'it'\\''s'");
    EXPECT_EQ(parsed({"--check=run make", "n", "h"}).refresh, "run make");
    EXPECT_EQ(errorsOf({"--check", "--depfile=d", "--list-outputs", "--dump=view", "n", "h"}).size(), 3U);
}

TEST(Options, SayWhichEntryOnlyOfADatabase) {
    EXPECT_EQ(parsed({"-pbuild", "--compile-database-for=x.cpp", "n", "h"}).database, "build");
    EXPECT_EQ(errorsOf({"--compile-database-for=x.cpp", "n", "h"}).size(), 1U);
}

TEST(Options, ReportEveryFault) {
    const auto errors = errorsOf({"--dmp=view", "--dump=x", "-o", "", "-Wall", "n"});
    ASSERT_EQ(errors.size(), 5U);
    EXPECT_NE(errors[0].find("did you mean '--dump'"), std::string::npos) << errors[0];
}

TEST(Options, DealOutTheTypesOfAHeader) {
    const auto options = parsed({"--pieces=a=b.hpp=12", "--pieces", "c.hpp=1", "n", "a=b.hpp", "c.hpp"});
    EXPECT_EQ(options.pieces, (std::map<std::string, std::size_t>{{"a=b.hpp", 12}, {"c.hpp", 1}}));
    for (const char* value : {"", "h", "=2", "h=", "h=0", "h=x", "h=-1", "h=1001", "h=99999999999999999999"})
        EXPECT_FALSE(errorsOf({std::string("--pieces=") + value, "n", "h"}).empty()) << value;
}

TEST(Options, RefuseNamesThatAreNoFileNames) {
    EXPECT_EQ(errorsOf({"a/b", "h"}).size(), 1U);
    EXPECT_EQ(errorsOf({"..", "h"}).size(), 1U);
    EXPECT_EQ(parsed({"my-pkg.v2", "h"}).name, "my-pkg.v2");
}

TEST(Options, NeedAValueWhereOneIsDue) { EXPECT_FALSE(errorsOf({"n", "h", "--depfile"}).empty()); }

TEST(Options, HelpNeedsNothingElse) { EXPECT_TRUE(parsed({"--help"}).help); }

TEST(Options, DoubleDashEndsOptions) {
    EXPECT_EQ(parsed({"--", "n", "-h.hpp"}).inputs, (std::vector<std::string>{"-h.hpp"}));
}
