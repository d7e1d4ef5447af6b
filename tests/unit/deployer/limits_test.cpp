// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What an input asks for has limits.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

#include <sys/resource.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define OROFORGE_OWN_MEMORY 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define OROFORGE_OWN_MEMORY 1
#endif
#endif

namespace {

using namespace oroforge::test;
using testing::HasSubstr;

class Limits : public deployer_test::DeployerInDirectory {
protected:
    /** What rttscript says of a script with that text. */
    Outcome runText(const std::string& text, const std::vector<std::string>& options = {}) {
        directory_.write("app.ops", text + '\n');
        Command script = command(options);
        script.program = RTTSCRIPT_PROGRAM;
        script.arguments.push_back("app.ops");
        return run(script);
    }
};

TEST_F(Limits, ScriptsGetNoSequenceOfMoreElementsThanTheLimit) {
    for (const char* sized : {"var array a(2147483647)", "var string a(2147483647)", "var rt_string a(2147483647)"}) {
        const Outcome outcome = runText(std::string("\n") + sized);
        EXPECT_EQ(255, outcome.status) << sized;
        EXPECT_THAT(outcome.err, HasSubstr("app.ops:2:")) << sized;
        EXPECT_THAT(outcome.err,
                    HasSubstr("[OPS114] 'a' cannot have 2147483647 elements: the limit is 10000000; the option "
                              "--max-elements of the deployer"))
            << sized;
    }
    for (const char* made : {"a = array(2147483647)", "a = array(2147483647, 1.0)"}) {
        const Outcome outcome = runText(std::string("var array a\n") + made);
        EXPECT_EQ(255, outcome.status) << made;
        EXPECT_THAT(outcome.err,
                    HasSubstr("app.ops:2:1: error: [OPS400] there can be no value with 2147483647 elements: "
                              "the limit is 10000000; the option --max-elements of the deployer"))
            << made;
    }
}

TEST_F(Limits, AnOptionSetsTheNumberOfElements) {
    EXPECT_EQ(255, runText("var array a(20)", {"--max-elements", "19"}).status);
    EXPECT_EQ(255, runText("var array a = array(20)", {"--max-elements", "19"}).status);
    EXPECT_EQ(0, runText("var array a(20)\na = array(20)", {"--max-elements", "20"}).status);
    const Outcome wrong = runText("var array a(1)", {"--max-elements", "0"});
    EXPECT_EQ(255, wrong.status);
    EXPECT_THAT(wrong.err, HasSubstr("no number of elements: 0"));
}

/** Mebibytes that the largest child of this process had in RAM. */
[[maybe_unused]] long mostMemoryOfChildren() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return usage.ru_maxrss / 1024;
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i != times; ++i) all += text;
    return all;
}

TEST_F(Limits, ManyElementsTakeLittleMemory) {
    const int times = 200000;
    directory_.write(
        "many.xml",
        "<properties>\n" +
            repeated("<simple name=\"Import\" type=\"string\"><value>deploytest</value></simple>\n", times) +
            "</properties>\n");
    const Outcome outcome = run(command({"--dry-run", "-s", "many.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err.substr(0, 1000);
#ifndef OROFORGE_OWN_MEMORY
    EXPECT_LT(mostMemoryOfChildren(), 130);
#endif
}

TEST_F(Limits, ManyPropertiesInAFileTakeLittleMemory) {
    const int times = 100000;
    directory_.write("many.cpf",
                     "<properties>\n" +
                         repeated("<simple name=\"first\" type=\"long\"><value>1</value></simple>\n", times) +
                         "</properties>\n");
    directory_.write("app.xml",
                     "<properties><simple name=\"Import\" type=\"string\"><value>deploytest</value></simple>\n"
                     "<struct name=\"c\" type=\"deploytest::Producer\"><simple name=\"PropertyFile\" "
                     "type=\"string\"><value>many.cpf</value></simple></struct></properties>\n");
    const Outcome outcome = run(command({"--dry-run", "-s", "app.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err.substr(0, 1000);
#ifndef OROFORGE_OWN_MEMORY
    EXPECT_LT(mostMemoryOfChildren(), 130);
#endif
}

}  // namespace
