// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values in deployment and property files that the deployer must not guess at.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

const char* const kImport = "<simple name=\"Import\" type=\"string\"><value>deploytest</value></simple>\n";

std::string simple(const std::string& name, const std::string& type, const std::string& value) {
    return "<simple name=\"" + name + "\" type=\"" + type + "\"><value>" + value + "</value></simple>\n";
}

class Values : public deployer_test::DeployerInDirectory {
protected:
    Outcome deploy(const std::string& content, std::vector<std::string> options = {}) {
        directory_.write("app.xml", "<properties>\n" + std::string(kImport) +
                                        "<struct name=\"one\" type=\"deploytest::Consumer\">\n" + content +
                                        "</struct>\n</properties>\n");
        options.insert(options.end(), {"--check", "--no-consolelog", "-s", "app.xml"});
        return run(command(options));
    }
    static std::string period(const std::string& value) {
        return "<struct name=\"Activity\" type=\"Activity\">\n" + simple("Period", "double", value) + "</struct>\n";
    }
};

TEST_F(Values, TextBehindANumberEndsTheDeployment) {
    const Outcome comma = deploy(period("0,02"));
    EXPECT_EQ(255, comma.status);
    EXPECT_THAT(comma.err, HasSubstr("app.xml:5:44: error: [CPF007] the value of 'Period' is '0,02', with text after "
                                     "the number; expected a number of seconds, or one with the unit s, ms or us\n"));
    const Outcome lenient = deploy(period("0,02"), {"--lenient"});
    EXPECT_EQ(0, lenient.status) << lenient.err;
    EXPECT_THAT(lenient.err, HasSubstr("app.xml:5:44: warning: [CPF007]"));
    const Outcome unit = deploy(period("20ms"));
    EXPECT_EQ(0, unit.status) << unit.err;
    EXPECT_EQ("", unit.err);
}

TEST_F(Values, TextBehindANumberInAPropertyFileNamesFileLineAndProperty) {
    directory_.write("one.cpf", "<properties>\n" + simple("count", "long", "2.7") + "</properties>\n");
    const std::string file = simple("UpdateProperties", "string", "one.cpf");
    const Outcome outcome = deploy(file);
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("one.cpf:2:41: error: [CPF007] property 'count' of type long cannot be '2.7', "
                                       "with text after the number; expected a whole number\n"));
    EXPECT_EQ(0, deploy(file, {"--lenient"}).status);
}

TEST_F(Values, FilesThatIncludeTheNextTwiceEndQuickly) {
    for (int i = 0; i != 18; ++i) {
        const std::string next = simple("Include", "string", "f" + std::to_string(i + 1) + ".xml");
        directory_.write("f" + std::to_string(i) + ".xml", "<properties>\n" + next + next + "</properties>\n");
    }
    directory_.write("f18.xml", "<properties>" + std::string(kImport) + "</properties>\n");
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = run(command({"--dry-run", "--no-consolelog", "-s", "f0.xml"}));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("error: [DEP064] this is the include after the first 1000"));
    EXPECT_EQ(outcome.err.find("[DEP064]"), outcome.err.rfind("[DEP064]")) << outcome.err;
}

TEST_F(Values, TextBetweenElementsIsAnError) {
    const Outcome outcome = deploy("AutoStart\n");
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("app.xml:4:1: error: [DEP062] found the text 'AutoStart' in <struct>; expected "
                                       "elements only\n"));
    EXPECT_EQ(0, deploy("AutoStart\n", {"--lenient"}).status);
    directory_.write("one.cpf", "<properties>\n lost\n" + simple("count", "long", "2") + "</properties>\n");
    const Outcome file = deploy(simple("UpdateProperties", "string", "one.cpf"));
    EXPECT_EQ(255, file.status);
    EXPECT_THAT(file.err, HasSubstr("one.cpf:2:2: error: [CPF008] found the text 'lost' in <properties>"));
}

TEST_F(Values, OtherEncodingsAndControlBytesAreErrorsWithAPlace) {
    const std::string file = simple("UpdateProperties", "string", "one.cpf");
    for (const auto& [text, where] : std::vector<std::pair<std::string, std::string>>{
             {"<properties>\n<!-- K\xf6rper -->\n</properties>\n", "one.cpf:2:7: error: [XML009]"},
             {"<properties>\n\x1b[2J</properties>\n", "one.cpf:2:1: error: [XML009]"}}) {
        directory_.write("one.cpf", text);
        const Outcome outcome = deploy(file);
        EXPECT_EQ(255, outcome.status);
        EXPECT_THAT(outcome.err, HasSubstr(where));
        EXPECT_THAT(outcome.err, Not(HasSubstr("\x1b")));
    }
    const Outcome latin = deploy("<!-- K\xf6rper -->\n");
    EXPECT_EQ(255, latin.status);
    EXPECT_THAT(latin.err, HasSubstr("app.xml:4:7: error: [XML009] found the byte 0xf6, expected text in UTF-8\n"));
}

TEST_F(Values, NamesOfComponentsCannotForgeLogLinesOrLeaveTheFolder) {
    const std::string struct_ = "\" type=\"deploytest::Consumer\"/></properties>\n";
    for (const char* name : {"a&#10;9.999 [ FATAL  ] forged", "../x", "a&#27;[2J"}) {
        directory_.write("app.xml", "<properties>" + std::string(kImport) + "<struct name=\"" + name + struct_);
        const Outcome outcome = run(command({"--check", "-linfo", "-s", "app.xml"}));
        EXPECT_EQ(255, outcome.status) << name;
        EXPECT_THAT(outcome.err, HasSubstr("app.xml:2:15: error: [DEP063] component '")) << name;
        EXPECT_THAT(outcome.err + readFile(directory_ / "orocos.log"), Not(HasSubstr("\n9.999")));
        EXPECT_THAT(outcome.err, Not(HasSubstr("\x1b")));
    }
    for (const char* statement :
         {"loadComponent(\"../x\", \"deploytest::Consumer\")",
          "loadComponent(\"a\\n9.999 forged\", \"deploytest::Consumer\")", "aliasPeer(\"one\", \"two\", \"../x\")"}) {
        directory_.write("app.ops",
                         "import(\"deploytest\")\nloadComponent(\"one\", \"deploytest::Consumer\")\n"
                         "loadComponent(\"two\", \"deploytest::Consumer\")\n" +
                             std::string(statement) + "\n");
        const Outcome outcome = run(command({"--strict", "app.ops"}));
        EXPECT_EQ(255, outcome.status) << statement;
        EXPECT_THAT(outcome.err + readFile(directory_ / "orocos.log"), Not(HasSubstr("\n9.999"))) << statement;
    }
    const Outcome named = run(command({"a\tb", "app.ops"}));
    EXPECT_EQ(255, named.status);
    EXPECT_THAT(named.err, HasSubstr("'a?b' is no name for the deployer"));
}

}  // namespace
