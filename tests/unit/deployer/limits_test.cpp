// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What an input asks for has limits.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

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

}  // namespace
