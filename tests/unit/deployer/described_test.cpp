// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Files about components that their library describes: what is found before anything is created. The package is described/.
#include "deployer_program.hpp"
#include "file_opens.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

const char* const kImport = "<simple name=\"Import\" type=\"string\"><value>described</value></simple>\n";

std::string component(const std::string& name, const std::string& type, const std::string& content = "") {
    return "<struct name=\"" + name + "\" type=\"" + type + "\">\n" + content + "</struct>\n";
}

std::string port(const std::string& name, const std::string& connection) {
    return "  <struct name=\"Ports\" type=\"PropertyBag\">\n    <simple name=\"" + name + "\" type=\"string\"><value>" +
           connection + "</value></simple>\n  </struct>\n";
}

std::string property(const std::string& name) {
    return "  <struct name=\"Properties\" type=\"PropertyBag\">\n    <simple name=\"" + name +
           "\" type=\"long\"><value>1</value></simple>\n  </struct>\n";
}

const char* const kStart = "  <simple name=\"AutoStart\" type=\"boolean\"><value>1</value></simple>\n";

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
    return found;
}

class DescribedComponents : public deployer_test::DeployerInDirectory {
protected:
    Outcome deploy(const std::string& mode, const std::string& elements) {
        directory_.write("app.xml", "<properties>\n" + std::string(kImport) + elements + "</properties>\n");
        return run(command({mode, "--no-consolelog", "-s", "app.xml"}));
    }
};

TEST_F(DescribedComponents, ADryRunTellsAllErrorsAndCreatesNothing) {
    const Outcome outcome =
        deploy("--dry-run", component("source", "described::Source", port("nubmers", "wire") + property("frist")) +
                                component("words", "described::Source", port("words", "mixed")) +
                                component("sink", "described::Sink", port("numbers", "mixed")) +
                                component("one", "described::Sink", port("numbers", "inputs")) +
                                component("two", "described::Sink", port("numbers", "inputs")));
    EXPECT_EQ(255, outcome.status);
    EXPECT_EQ("", outcome.out);
    EXPECT_EQ(R"(app.xml:5:19: error: [DEP040] component 'source' has no port 'nubmers'; did you mean 'numbers'?
    <simple name="nubmers" type="string"><value>wire</value></simple>
                  ^
app.xml:3:29: note: the manifest of package 'described' lists the ports: 'numbers', 'words', 'gauge.level'
<struct name="source" type="described::Source">
                            ^
note: if the class adds ports by itself, say dynamic="true" for the component in that manifest
app.xml:8:19: error: [DEP043] component 'source' has no property 'frist'; did you mean 'first'?
    <simple name="frist" type="long"><value>1</value></simple>
                  ^
app.xml:3:29: note: the manifest of package 'described' lists the properties: 'first', 'label', 'gauge.scale'
<struct name="source" type="described::Source">
                            ^
note: if the class adds properties by itself, say dynamic="true" for the component in that manifest
app.xml:18:19: error: [DEP041] port 'sink.numbers' of type 'int' cannot take part in connection 'mixed' of type 'string'
    <simple name="numbers" type="string"><value>mixed</value></simple>
                  ^
app.xml:13:19: note: port 'words.words' gives the connection its type
    <simple name="words" type="string"><value>mixed</value></simple>
                  ^
app.xml:23:19: error: [DEP042] no output port takes part in connection 'inputs'
    <simple name="numbers" type="string"><value>inputs</value></simple>
                  ^
app.xml:23:19: note: port 'one.numbers' is an input
    <simple name="numbers" type="string"><value>inputs</value></simple>
                  ^
app.xml:28:19: note: port 'two.numbers' is an input
    <simple name="numbers" type="string"><value>inputs</value></simple>
                  ^
)",
              outcome.err);
}

TEST_F(DescribedComponents, ADryRunTriesValuesOnTheTypesOfProperties) {
    const auto given = [](const std::string& simple) {
        return "  <struct name=\"Properties\" type=\"PropertyBag\">\n    " + simple + "\n  </struct>\n";
    };
    directory_.write("source.cpf",
                     "<properties>\n<simple name=\"first\" type=\"double\"><value>2.7</value></simple>\n"
                     "<simple name=\"label\" type=\"boolean\"><value>1</value></simple>\n</properties>\n");
    const Outcome outcome =
        deploy("--dry-run",
               component("one", "described::Source",
                         given("<simple name=\"first\" type=\"string\"><value>many</value></simple>")) +
                   component("two", "described::Source",
                             "<simple name=\"UpdateProperties\" type=\"string\"><value>source.cpf</value></simple>\n"));
    EXPECT_EQ(255, outcome.status);
    EXPECT_EQ("", outcome.out);
    EXPECT_THAT(outcome.err,
                HasSubstr("app.xml:5:5: error: [DEP052] component 'one': property 'first' of type int cannot "
                          "take a value of type string\n"));
    EXPECT_THAT(outcome.err, HasSubstr("source.cpf:3:1: error: [CPF020] property 'label' of type string cannot take"));
}

TEST_F(DescribedComponents, APropertyFileIsReadOnce) {
    directory_.write("source.cpf",
                     "<properties><simple name=\"first\" type=\"long\"><value>1</value></simple>"
                     "<simple name=\"label\" type=\"string\"><value>a</value></simple></properties>\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // a file that has just changed is read again
    const auto from = [](const std::string& statement) {
        return "  <simple name=\"" + statement + "\" type=\"string\"><value>source.cpf</value></simple>\n";
    };
    deployer_test::FileOpens opens((directory_.path() / "source.cpf").string());
    for (const char* mode : {"--dry-run", "--check", "-lerror"}) {
        const Outcome outcome = deploy(mode, component("one", "described::Source", from("PropertyFile")) +
                                                 component("two", "described::Source", from("UpdateProperties")));
        EXPECT_EQ(0, outcome.status) << outcome.err;
        EXPECT_EQ(1, opens.count()) << mode;
    }
}

TEST_F(DescribedComponents, ADryRunEndsWithASummary) {
    const Outcome outcome =
        deploy("--dry-run", component("source", "described::Source", port("numbers", "wire") + property("first")) +
                                component("sink", "described::Sink", port("numbers", "wire")));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ("2 components, 1 connection: ok; scripts not executed\n", outcome.out);
}

TEST_F(DescribedComponents, TypesDifferBeforeAnythingIsCreatedInEveryMode) {
    const std::string elements = component("words", "described::Source", port("words", "mixed")) +
                                 component("sink", "described::Sink", port("numbers", "mixed"));
    for (const char* mode : {"--dry-run", "--check"}) {
        const Outcome outcome = deploy(mode, elements);
        EXPECT_EQ(255, outcome.status);
        EXPECT_EQ("", outcome.out);
        EXPECT_EQ(1u, count(outcome.err, "[DEP041]")) << outcome.err;
    }
}

TEST_F(DescribedComponents, EachErrorIsToldOnceByTheLevelThatKnowsBest) {
    const Outcome outcome =
        deploy("--check", component("source", "described::Source", port("nubmers", "wire") + property("frist")) +
                              component("one", "described::Sink", port("numbers", "inputs")) +
                              component("two", "described::Sink", port("numbers", "inputs")));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.out, HasSubstr("source: created"));
    for (const char* code : {"[DEP040]", "[DEP042]", "[DEP043]"}) EXPECT_EQ(1u, count(outcome.err, code)) << code;
}

TEST_F(DescribedComponents, WhatAClassAddsByItselfKeepsNobodyFromRunning) {
    const std::string elements =
        component("source", "described::Source", port("numbers", "wire")) +
        component("more", "described::Secretive", port("extra", "wire") + property("hidden") + kStart);
    const Outcome checked = deploy("--check", elements);
    EXPECT_EQ(0, checked.status) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("more: created"));
    EXPECT_THAT(checked.out, Not(HasSubstr("started")));
    const Outcome started = run(command({"-s", "app.xml"}));  // its console finds no input and ends
    EXPECT_EQ(0, started.status) << started.err;
    EXPECT_THAT(started.out, HasSubstr("more: started"));
    EXPECT_THAT(started.err, Not(HasSubstr("DEP0")));
    // Nobody knows that before one is there, and the message says so.
    const Outcome planned = deploy("--dry-run", elements);
    EXPECT_EQ(255, planned.status);
    EXPECT_THAT(planned.err, HasSubstr("component 'more' has no port 'extra'"));
    EXPECT_THAT(planned.err, HasSubstr("component 'more' has no property 'hidden'"));
    EXPECT_THAT(planned.err, HasSubstr("say dynamic=\"true\""));
}

TEST_F(DescribedComponents, AManifestMaySayThatThereIsMore) {
    const std::string elements = component("source", "described::Source", port("numbers", "wire")) +
                                 component("more", "described::Grows", port("extra", "wire") + property("hidden"));
    for (const char* mode : {"--dry-run", "--check"}) {
        const Outcome outcome = deploy(mode, elements);
        EXPECT_EQ(0, outcome.status) << outcome.err;
        EXPECT_EQ("", outcome.err);
    }
}

TEST_F(DescribedComponents, ServicesAreDescribedToo) {
    const std::string good = component("source", "described::Source", port("gauge.level", "wire")) +
                             component("sink", "described::Sink", port("numbers", "wire"));
    for (const char* mode : {"--dry-run", "--check"}) EXPECT_EQ(0, deploy(mode, good).status) << mode;
    EXPECT_THAT(deploy("--dry-run", component("source", "described::Source", port("gauge.levle", "wire"))).err,
                HasSubstr("no port 'gauge.levle'; did you mean 'gauge.level'?"));
}

TEST_F(DescribedComponents, FilesAreCheckedAgainstThoseBefore) {
    directory_.write("first.xml", "<properties>\n" + std::string(kImport) +
                                      component("words", "described::Source", port("words", "wire")) +
                                      "</properties>\n");
    directory_.write("second.xml", "<properties>\n" + component("sink", "described::Sink", port("numbers", "wire")) +
                                       "</properties>\n");
    const Outcome outcome = run(command({"--dry-run", "-s", "first.xml", "-s", "second.xml"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("second.xml:4:19: error: [DEP041] port 'sink.numbers' of type 'int'"));
    EXPECT_EQ(1u, count(outcome.err, "error:")) << outcome.err;
}

}  // namespace
