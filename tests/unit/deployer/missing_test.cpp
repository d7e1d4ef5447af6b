// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a dry run tells of scripts in XML files, and of typekits that are not there.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

class DryRunOfParts : public deployer_test::DeployerInDirectory {
protected:
    Outcome deploy(const std::string& imports, const std::string& elements,
                   const std::vector<std::string>& options = {"--dry-run"}) {
        std::string text = "<properties>\n";
        for (std::size_t begin = 0, end; begin < imports.size(); begin = end + 1) {
            end = std::min(imports.find(' ', begin), imports.size());
            text += "<simple name=\"Import\" type=\"string\"><value>" + imports.substr(begin, end - begin) +
                    "</value></simple>\n";
        }
        directory_.write("app.xml", text + elements + "</properties>\n");
        Command deployer = command(options);
        deployer.arguments.insert(deployer.arguments.end(), {"-s", "app.xml"});
        deployer.environment["RTT_COMPONENT_PATH"] = TYPEKITS_TEST_PATH ":" DEPLOYER_TEST_PATH;
        return run(deployer);
    }

    Outcome deployWithScript(const std::string& kind, const std::string& script) {
        directory_.write("part.osd", script);
        return deploy("deploytest", "<struct name=\"one\" type=\"deploytest::Consumer\">\n<simple name=\"" + kind +
                                        "\" type=\"string\"><value>part.osd</value></simple>\n</struct>\n");
    }
};

const char* const kStation = "<struct name=\"roof\" type=\"station::Station\">";

TEST_F(DryRunOfParts, StatesThatAScriptSelectsHaveToExist) {
    const std::string machine =
        "StateMachine Gate {\n"
        "  initial state CLOSED {\n    transitions { select OPNE }\n  }\n"
        "  state OPEN {\n    transitions { if numbers.read(x) == NewData then select CLOSED }\n    var int x\n  }\n"
        "  final state END {}\n}\nRootMachine Gate gate\n";
    for (const char* kind : {"RunScript", "StateMachineScript"}) {
        const Outcome outcome = deployWithScript(kind, machine);
        EXPECT_EQ(255, outcome.status);
        EXPECT_THAT(outcome.err, HasSubstr("part.osd:3:26: error: [OPS306]")) << kind;
        EXPECT_THAT(outcome.err, HasSubstr("'OPNE'"));
        EXPECT_THAT(outcome.out, Not(HasSubstr("created")));
    }
}

TEST_F(DryRunOfParts, ScriptsAreCompiledAsFarAsTheComponentIsNotAskedFor) {
    const Outcome type = deployWithScript("RunScript", "var int i = 1\ni = \"text\"\nnothere.start()\n");
    EXPECT_EQ(255, type.status);
    EXPECT_THAT(type.err, HasSubstr("part.osd:2:"));
    EXPECT_THAT(type.err, Not(HasSubstr("nothere")));
    const Outcome missing = deployWithScript("RunScript", "RootMachine Gaet gate\n");
    EXPECT_EQ(0, missing.status) << "a script before may have the type: " << missing.err;
    const Outcome good = deployWithScript(
        "RunScript",
        "speed = 2.5\nlimits.low = 1\nmotor.configure()\nprogram p { do nothing(1) until { if x then }\n}\n");
    EXPECT_THAT(good.err, Not(HasSubstr("'speed'")));
}

TEST_F(DryRunOfParts, AComponentMayHaveOperationsOfItsOwnUnderUsualNames) {
    const Outcome outcome = deployWithScript("RunScript", "update(5)\nerror(\"text\")\nvar int i = start(1, 2)\n");
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ("", outcome.err);
}

TEST_F(DryRunOfParts, ScriptsOfOlderNamesHaveWhatTheirNameSays) {
    const Outcome statement = deployWithScript("ProgramScript", "program p { yield }\nvar int i = 1\n");
    EXPECT_EQ(255, statement.status);
    EXPECT_THAT(statement.err, HasSubstr("part.osd:2:1: error: [OPS412] found a statement"));
    const Outcome none =
        deployWithScript("StateMachineScript", "StateMachine M { initial state A {} final state B {} }\n");
    EXPECT_EQ(255, none.status);
    EXPECT_THAT(none.err, HasSubstr("error: [OPS413] found no RootMachine"));
    EXPECT_EQ(0, deployWithScript("ProgramScript", "program p { yield }\n").status);
}

TEST_F(DryRunOfParts, AMissingTypekitIsNamedWithItsPackage) {
    const Outcome missing = deploy("station", std::string(kStation) + "</struct>\n");
    EXPECT_EQ(0, missing.status) << "components can be connected without it";
    EXPECT_EQ(
        "app.xml:3:27: warning: [DEP066] no loaded typekit has the type 'greenhouse::Climate' of port "
        "'roof.climate'\n" +
            std::string(kStation) +
            "</struct>\n                          ^\n"
            "note: the typekit of package 'greenhouse' has it: <simple name=\"Import\" type=\"string\"><value>"
            "greenhouse</value></simple>\n",
        missing.err);
    const Outcome there = deploy("station greenhouse", std::string(kStation) + "</struct>\n");
    EXPECT_EQ(0, there.status);
    EXPECT_EQ("", there.err);
}

TEST_F(DryRunOfParts, ATransportNeedsATypekit) {
    const std::string policy =
        "<struct name=\"wire\" type=\"ConnPolicy\"><simple name=\"transport\" type=\"short\"><value>2</value></simple>"
        "</struct>\n";
    const std::string ports =
        "\n<struct name=\"Ports\" type=\"PropertyBag\"><simple name=\"inner\" type=\"string\"><value>wire</value>"
        "</simple></struct></struct>\n";
    const Outcome outcome = deploy("station greenhouse", policy + kStation + ports);
    EXPECT_THAT(outcome.err, HasSubstr("app.xml:6:55: warning: [DEP066] no loaded typekit has the type "
                                       "'greenhouse::Private' of port 'roof.inner'"));
}

TEST_F(DryRunOfParts, APropertyOfSuchATypeIsAnErrorThatNamesThePackage) {
    const Outcome outcome = deploy(
        "station", std::string(kStation) +
                       "\n<struct name=\"Properties\" type=\"PropertyBag\"><struct name=\"limits\" "
                       "type=\"/greenhouse/Climate\"><simple name=\"temperature\" type=\"double\"><value>20</value>"
                       "</simple></struct></struct></struct>\n");
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err,
                HasSubstr("[DEP065] component 'roof': no loaded typekit has the type 'greenhouse::Climate' "
                          "of property 'limits'"));
    EXPECT_THAT(outcome.err, HasSubstr("note: the typekit of package 'greenhouse' has it"));
}

}  // namespace
