// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Libraries of components (section 3): loaded ones are those that search_test.cpp imports.
#include "snippets.hpp"

namespace {

using namespace manual_test;
using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;

class Libraries : public Snippets {};

TEST_F(Libraries, OfOneTypeAndOfSeveralInSeveralFilesAreLoaded) {
    expectAtPrompt({}, {{"import(\"" ROBOT_ARM_FILE "\")", kTrue},
                        {"import(\"" ROBOT_13_FILE "\")", kTrue},
                        {"loadComponent(\"a\", \"robot::Arm\")", kTrue},
                        {"loadComponent(\"c\", \"Robot13::Controller\")", kTrue},
                        {"loadComponent(\"d\", \"Robot13::Diagnostics\")", kTrue}});
}

TEST_F(Libraries, TheOldMacroMakesTheSame) {
    expectAtPrompt({}, {{"import(\"" ROBOT_OLD_FILE "\")", kTrue},
                        {"loadComponent(\"c\", \"Robot13::Controller\")", kTrue},
                        {"loadComponent(\"d\", \"Robot13::Diagnostics\")", kTrue}});
}

TEST_F(Libraries, StaticOnesInAnExecutableAreFoundByItsDeployer) {
    writeXml("app.xml",
             bag("x", "linked::PartX", bag("Ports", "PropertyBag", simple("out", "string", "Flow"))) +
                 bag("z", "linked::PartZ", bag("Ports", "PropertyBag", simple("in", "string", "Flow")) + peer("x")) +
                 bag("one", "linked::One", simple("AutoStart", "boolean", "1")) + bag("two", "linked::Two", ""));
    const Outcome outcome = run(command(LINKED_PROGRAM, {"app.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("   linked::One\n"), HasSubstr("   linked::PartX\n   linked::PartZ\n"),
                                   HasSubstr("   linked::Two\n"), testing::EndsWith("one\ntwo\nx\nz\n")));
}

TEST_F(Libraries, StaticOnesCannotBeLoaded) {
    const Outcome outcome = atPrompt({}, {{"import(\"" LINKED_LIBRARY "\")", kFalse}});
    EXPECT_THAT(outcome.err,
                HasSubstr(LINKED_LIBRARY ": it is a static library, which can only be linked into a program"));
}

}  // namespace
